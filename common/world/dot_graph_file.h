#pragma once
// The `.graph` format of the ROS patrolling_sim, read by tokens: blank lines and line ends do not
// matter, but errors and warnings name the line of the token (`FILE:LINE: rule, got VALUE`).
//
// Six numbers (vertices, width px, height px, metres per px, offset x m, offset y m), then for each
// vertex its id, x px, y px and number of neighbours, and for each neighbour its id, a compass word
// and a cost in px. Positions: px · metres per px + offset. Internal to graph_file.
#include <string>
#include <string_view>
#include <vector>

#include "common/world/graph_file.h"

namespace ronda {

/// Throws InputError; what the whole graph must satisfy (connected, …) PatrolGraph checks.
GraphData ParseDotGraph(std::string_view text, const std::string& file,
                        EdgeLengthSource length_source, std::vector<std::string>& warnings);

}  // namespace ronda
