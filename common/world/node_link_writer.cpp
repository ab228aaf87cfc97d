#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "common/base/whole_file.h"
#include "common/world/graph_file.h"

namespace ronda {
namespace {

using Json = nlohmann::ordered_json;

/// An id that reads as an integer and is written like one is an integer, any other a string.
Json IdOf(const std::string& id) {
  long long value = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), value);
  const bool is_integer = error == std::errc() && end == id.data() + id.size();
  return is_integer && std::to_string(value) == id ? Json(value) : Json(id);
}

Json AttributesOf(const PatrolGraph& graph) {
  Json attributes;
  attributes["name"] = graph.name();
  if (!graph.source().empty()) attributes["source"] = graph.source();
  attributes["metres_per_px"] = graph.metres_per_px();
  if (const auto& walk = graph.shortest_closed_walk()) {
    Json ids = Json::array();
    for (const int vertex : walk->vertices) ids.push_back(IdOf(graph.vertex_id(vertex)));
    attributes["shortest_closed_walk"] = {
        {"length_m", walk->length_m}, {"source", walk->source}, {"vertices", ids}};
  }
  return attributes;
}

Json LinkOf(const PatrolGraph& graph, const Edge& edge) {
  Json link{{"source", IdOf(graph.vertex_id(edge.source))},
            {"target", IdOf(graph.vertex_id(edge.target))}};
  const double distance_m =
      Distance_m(graph.positions()[edge.source], graph.positions()[edge.target]);
  constexpr double kRounding = 1e-12;  // relative
  if (distance_m < kSamePoint_m ||
      std::abs(edge.length_m - distance_m) > kRounding * edge.length_m) {
    link["length"] = edge.length_m;
  }
  return link;
}

/// A list with one element a line.
std::string Lines(const std::vector<std::string>& elements) {
  return fmt::format("[\n    {}\n  ]", fmt::join(elements, ",\n    "));
}

}  // namespace

std::string NodeLinkText(const PatrolGraph& graph) {
  const Json known = AttributesOf(graph);
  std::vector<std::string> attributes;  // a file's name may be no UTF-8
  for (const auto& [key, value] : known.items()) {
    attributes.push_back(fmt::format("{}: {}", Json(key).dump(),
                                     value.dump(-1, ' ', false, Json::error_handler_t::replace)));
  }
  std::vector<std::string> nodes;
  for (int vertex = 0; vertex < graph.vertex_count(); ++vertex) {
    const Position& at = graph.positions()[vertex];
    Json node{{"id", IdOf(graph.vertex_id(vertex))}, {"pos", {at.x_m, at.y_m}}};
    if (!graph.unweighted()) node["priority"] = graph.priorities()[vertex];
    nodes.push_back(node.dump());
  }
  std::vector<std::string> links;
  for (const Edge& edge : graph.edges()) links.push_back(LinkOf(graph, edge).dump());

  return fmt::format(
      "{{\n  \"directed\": false,\n  \"multigraph\": false,\n  \"graph\": {{\n    {}\n  }},\n"
      "  \"nodes\": {},\n  \"links\": {}\n}}\n",
      fmt::join(attributes, ",\n    "), Lines(nodes), Lines(links));
}

void WriteNodeLink(const PatrolGraph& graph, const std::filesystem::path& path) {
  WriteWholeFile(path, NodeLinkText(graph), Sync::kNo);
}

}  // namespace ronda
