#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <unordered_map>

#include "common/base/error.h"
#include "common/world/map_formats.h"

namespace ronda {
namespace {

using Json = nlohmann::json;

/// A JSON value with the path that leads to it, so that every error can name the element.
struct Element {
  const Json& value;
  std::string path;

  [[noreturn]] void Refuse(const std::string& rule) const {
    throw InputError(fmt::format("{}: {}", path, rule));
  }

  static std::string Shown(const Json& json) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() > 60 ? text.substr(0, 57) + "..." : text;
  }

  bool Has(const std::string& key) const { return value.contains(key) && !value[key].is_null(); }

  Element Member(const std::string& key) const {
    if (!value.is_object()) Refuse("must be an object, got " + Shown(value));
    if (!Has(key)) Refuse(fmt::format("the key '{}' is missing", key));
    return {value[key], path + (path.ends_with(": ") ? "" : ".") + key};
  }

  Element Item(std::size_t index) const {
    return {value[index], fmt::format("{}[{}]", path, index)};
  }

  std::size_t ArraySize() const {
    if (!value.is_array()) Refuse("must be an array, got " + Shown(value));
    return value.size();
  }

  double Number() const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
      Refuse("must be a finite number, got " + Shown(value));
    }
    return value.get<double>();
  }

  double PositiveNumber() const {
    if (Number() <= 0.0) Refuse("must be > 0, got " + Shown(value));
    return Number();
  }

  /// A vertex's id: a string or a number (1 and "1" are the same id).
  std::string Id() const {
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_number()) Refuse("an id must be a string or a number, got " + Shown(value));
    return value.dump();
  }
};

Json ParseJson(const std::string& text, const std::string& file_name) {
  try {
    return Json::parse(text);
  } catch (const Json::exception& error) {
    // nlohmann's message names line and column after its own tag "[json.exception.parse_error.101]
    // ".
    const std::string what = error.what();
    const auto tag_end = what.find("] ");
    throw InputError(fmt::format("{}: not valid JSON: {}", file_name,
                                 tag_end == std::string::npos ? what : what.substr(tag_end + 2)));
  }
}

using VertexIndex = std::unordered_map<std::string, int>;

int FindVertex(const Element& element, const VertexIndex& index) {
  const auto found = index.find(element.Id());
  if (found == index.end()) element.Refuse(fmt::format("no node has the id {}", element.Id()));
  return found->second;
}

VertexIndex ReadNodes(const Element& nodes, GraphData& data) {
  VertexIndex index;
  for (std::size_t i = 0; i < nodes.ArraySize(); ++i) {
    const Element node = nodes.Item(i);
    const Element id = node.Member("id");
    if (!index.emplace(id.Id(), static_cast<int>(i)).second) {
      id.Refuse(fmt::format("the id {} stands twice", id.Id()));
    }
    const Element pos = node.Member("pos");
    if (pos.ArraySize() != 2) {
      pos.Refuse("must be [x, y] in metres, got " + Element::Shown(pos.value));
    }
    data.vertex_ids.push_back(id.Id());
    data.positions.push_back({pos.Item(0).Number(), pos.Item(1).Number()});
  }
  return index;
}

std::vector<Edge> ReadLinks(const Element& links, const VertexIndex& index, const GraphData& data,
                            EdgeLengthSource length_source) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < links.ArraySize(); ++i) {
    const Element link = links.Item(i);
    const int source = FindVertex(link.Member("source"), index);
    const int target = FindVertex(link.Member("target"), index);
    if (source == target) link.Refuse("joins the node " + data.vertex_ids[source] + " to itself");
    double length_m = std::hypot(data.positions[target].x_m - data.positions[source].x_m,
                                 data.positions[target].y_m - data.positions[source].y_m);
    if (link.Has("length")) {
      length_m = link.Member("length").PositiveNumber();
    } else if (length_source == EdgeLengthSource::kFile) {
      link.Refuse("the key 'length' is missing, and lengths were asked to come from the file");
    }
    edges.push_back({source, target, length_m});
  }
  return edges;
}

void CheckBothArcs(const Element& links, const std::vector<Edge>& edges, const GraphData& data) {
  std::set<std::pair<int, int>> arcs;
  for (const Edge& edge : edges) arcs.emplace(edge.source, edge.target);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!arcs.contains({edges[i].target, edges[i].source})) {
      links.Item(i).Refuse(fmt::format(
          "a directed graph must have both arcs of each edge, but there is none from {} to {}",
          data.vertex_ids[edges[i].target], data.vertex_ids[edges[i].source]));
    }
  }
}

ClosedWalk ReadClosedWalk(const Element& element, const VertexIndex& index) {
  ClosedWalk walk;
  walk.length_m = element.Member("length_m").PositiveNumber();
  const Element vertices = element.Member("vertices");
  for (std::size_t i = 0; i < vertices.ArraySize(); ++i) {
    walk.vertices.push_back(FindVertex(vertices.Item(i), index));
  }
  if (walk.vertices.empty()) vertices.Refuse("must not be empty");
  if (element.Has("source")) walk.source = element.Member("source").Id();
  return walk;
}

Json IdAsJson(const std::string& id) {
  // Written back as a number where it reads back to the same id.
  const Json parsed = Json::parse(id, nullptr, false);
  return parsed.is_number_integer() && parsed.dump() == id ? parsed : Json(id);
}

}  // namespace

GraphData ParseNodeLinkGraph(const std::string& text, const std::string& file_name,
                             EdgeLengthSource length_source, std::vector<std::string>& warnings) {
  const Json json = ParseJson(text, file_name);
  const Element root{json, file_name + ": "};
  GraphData data;
  data.name = file_name;
  const VertexIndex index = ReadNodes(root.Member("nodes"), data);
  const Element links = root.Has("links") ? root.Member("links") : root.Member("edges");
  std::vector<Edge> edges = ReadLinks(links, index, data, length_source);
  const bool directed = root.Has("directed") && root.Member("directed").value == true;
  if (directed) CheckBothArcs(links, edges, data);
  if (root.Has("graph") && root.value["graph"].is_object()) {
    const Element attributes = root.Member("graph");
    if (attributes.Has("metres_per_px")) {
      data.metres_per_px = attributes.Member("metres_per_px").PositiveNumber();
    }
    if (attributes.Has("shortest_closed_walk")) {
      data.shortest_closed_walk = ReadClosedWalk(attributes.Member("shortest_closed_walk"), index);
    }
  }
  data.edges = MergeEdges(data, std::move(edges), directed, file_name, warnings);
  return data;
}

std::string WriteNodeLinkGraph(const PatrolGraph& graph, const std::string& source) {
  nlohmann::ordered_json json;
  json["directed"] = false;
  json["multigraph"] = false;
  auto& attributes = json["graph"];
  attributes["name"] = graph.name();
  attributes["source"] = source;
  attributes["metres_per_px"] = graph.metres_per_px();
  if (const auto& walk = graph.shortest_closed_walk()) {
    auto vertices = Json::array();
    for (const int v : walk->vertices) vertices.push_back(IdAsJson(graph.vertex_id(v)));
    attributes["shortest_closed_walk"]["length_m"] = walk->length_m;
    attributes["shortest_closed_walk"]["source"] = walk->source;
    attributes["shortest_closed_walk"]["vertices"] = vertices;
  }
  json["nodes"] = Json::array();
  for (int v = 0; v < graph.vertex_count(); ++v) {
    const Position position = graph.positions()[v];
    json["nodes"].push_back(
        {{"id", IdAsJson(graph.vertex_id(v))}, {"pos", {position.x_m, position.y_m}}});
  }
  json["links"] = Json::array();
  for (const Edge& edge : graph.edges()) {
    const Position from = graph.positions()[edge.source];
    const Position to = graph.positions()[edge.target];
    nlohmann::ordered_json link{{"source", IdAsJson(graph.vertex_id(edge.source))},
                                {"target", IdAsJson(graph.vertex_id(edge.target))}};
    if (edge.length_m != std::hypot(to.x_m - from.x_m, to.y_m - from.y_m)) {
      link["length"] = edge.length_m;
    }
    json["links"].push_back(link);
  }
  // One node or link a line: readable, and differences show.
  std::string text = json.dump(1);
  return text + "\n";
}

}  // namespace ronda
