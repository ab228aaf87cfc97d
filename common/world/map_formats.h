#pragma once
// The two map formats as text: `.graph` (ROS patrolling_sim) and NetworkX's node-link JSON. Facts:
// docs/maps.md.
//
// Parsers throw InputError that begins with `file_name` and names line or element, rule and value;
// what is odd but readable adds a sentence to `warnings`. The graph's own rules (connected,
// positive lengths, …) are PatrolGraph's. O(size of the text); what is allocated is bounded by the
// text, whatever counts it claims.
#include <string>
#include <string_view>
#include <vector>

#include "common/world/graph_file.h"
#include "common/world/patrol_graph.h"

namespace ronda {

GraphData ParsePatrolSimGraph(std::string_view text, const std::string& file_name,
                              EdgeLengthSource length_source, std::vector<std::string>& warnings);

GraphData ParseNodeLinkGraph(const std::string& text, const std::string& file_name,
                             EdgeLengthSource length_source, std::vector<std::string>& warnings);

/// Node-link JSON that ParseNodeLinkGraph and NetworkX read back to the same graph. `source` says
/// where its facts are from.
std::string WriteNodeLinkGraph(const PatrolGraph& graph, const std::string& source);

/// Edges as read: parallel ones are merged to the shortest (with a warning; `both_ways` says that
/// each edge is expected once in each direction, so only unequal lengths are worth one), and an
/// edge between two vertices on one point gets 1 mm, with a warning.
std::vector<Edge> MergeEdges(const GraphData& data, std::vector<Edge> edges, bool both_ways,
                             const std::string& file_name, std::vector<std::string>& warnings);

}  // namespace ronda
