#pragma once
// NetworkX's node-link JSON: `nodes` with `id` (an integer or a string), `pos` [x, y] in metres
// and, if it is not 1, `priority`; `links` (or `edges`) with `source`, `target` and, if it is not
// the distance between the ends, `length` in metres; `graph` holds what is known of the whole map.
// Other attributes are ignored.
//
// Errors name the element (`FILE: links[12].target: rule, got VALUE`), or line and column where the
// file is not JSON. Internal to graph_file. Source: networkx.readwrite.json_graph.node_link_data.
#include <string>
#include <string_view>
#include <vector>

#include "common/world/graph_file.h"

namespace ronda {

/// Throws InputError; what the whole graph must satisfy (connected, …) PatrolGraph checks.
GraphData ParseNodeLink(std::string_view text, const std::string& file,
                        EdgeLengthSource length_source, std::vector<std::string>& warnings);

}  // namespace ronda
