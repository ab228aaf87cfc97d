"""Opens the map IN with NetworkX, says what is in it, and writes it to OUT as NetworkX does."""

import inspect
import json
import sys

import networkx

# Newer versions ask how the list of edges is called; older ones know "links" only.
LINKS = ({"edges": "links"}
         if "edges" in inspect.signature(networkx.node_link_graph).parameters else {})

with open(sys.argv[1], encoding="utf-8") as file:
    graph = networkx.node_link_graph(json.load(file), **LINKS)
print(f"{type(graph).__name__}, {len(graph)} nodes, {graph.number_of_edges()} edges, "
      f"connected: {networkx.is_connected(graph)}, pos of 0: {graph.nodes[0]['pos']}")
with open(sys.argv[2], "w", encoding="utf-8") as file:
    json.dump(networkx.node_link_data(graph, **LINKS), file)
