#include "common/world/node_link_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <unordered_map>
#include <utility>

#include "common/base/error.h"
#include "common/world/shown_text.h"

namespace ronda {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxTextBytes = 200;

/// A value as an error shows it: short, and in printable ASCII.
std::string Shown(const Json& value) {
  if (value.is_object() || value.is_array()) {
    return fmt::format("{} of {}", value.is_object() ? "an object" : "a list", value.size());
  }
  return ShownText(value.dump(-1, ' ', true), 60);
}

Json ParseJson(std::string_view text, const std::string& file) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const std::size_t end = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const std::string_view before = text.substr(0, end);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    const std::string_view what = error.what();
    const std::size_t reason = what.find(" - ");  // after the library's own place
    throw InputError(fmt::format(
        "{}:{}:{}: the file must be JSON: {}", file, line, end - line_start + 1,
        reason == what.npos ? "syntax error" : ShownText(what.substr(reason + 3), 120)));
  } catch (const Json::exception&) {
    throw InputError(fmt::format("{}: the file must be JSON with numbers below 1.8e308", file));
  }
}

class NodeLinkParser {
 public:
  NodeLinkParser(const std::string& file, EdgeLengthSource length_source,
                 std::vector<std::string>& warnings)
      : file_(file), length_source_(length_source), warnings_(warnings) {}

  GraphData Parse(const Json& root) {
    if (!root.is_object()) Fail("the file", "must hold an object", root);
    ReadNodes(Member(root, "", "nodes"));
    ReadLinks(root);
    if (const auto attributes = root.find("graph"); attributes != root.end()) {
      ReadGraphAttributes(*attributes);
    }
    return std::move(data_);
  }

 private:
  [[noreturn]] void Fail(const std::string& element, const std::string& rule) const {
    throw InputError(fmt::format("{}: {}: {}", file_, element, rule));
  }
  [[noreturn]] void Fail(const std::string& element, const std::string& rule,
                         const Json& value) const {
    Fail(element, fmt::format("{}, got {}", rule, Shown(value)));
  }
  void Warn(const std::string& what) { warnings_.push_back(fmt::format("{}: {}", file_, what)); }

  const Json& Member(const Json& object, const std::string& element, const char* key) const {
    const auto found = object.find(key);
    if (found == object.end())
      Fail(element.empty() ? "the file" : element, fmt::format("must have `{}`", key));
    return *found;
  }

  double FiniteNumber(const Json& value, const std::string& element) const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
      Fail(element, "must be a finite number", value);
    }
    return value.get<double>();
  }

  double PositiveNumber(const Json& value, const std::string& element) const {
    if (!value.is_number() || !std::isfinite(value.get<double>()) || value.get<double>() <= 0.0) {
      Fail(element, "must be a positive finite number", value);
    }
    return value.get<double>();
  }

  double Priority(const Json& node, const std::string& element) const {
    const auto found = node.find("priority");
    if (found == node.end()) return 1.0;
    const double priority = found->is_number() ? found->get<double>() : 0.0;
    if (!IsPriority(priority)) {
      Fail(element + ".priority", "must be a number in 1e-6 … 1e6", *found);
    }
    return priority;
  }

  /// Of 0 to kMaxTextBytes, without control characters: it will stand in messages and tables.
  static bool IsText(const Json& value) {
    if (!value.is_string()) return false;
    const auto& text = value.get_ref<const std::string&>();
    const auto is_control = [](unsigned char c) { return std::iscntrl(c) != 0; };
    return text.size() <= kMaxTextBytes && std::ranges::none_of(text, is_control);
  }

  std::string Text(const Json& value, const std::string& element) const {
    if (!IsText(value)) {
      Fail(element,
           fmt::format("must be a string of up to {} bytes without control characters",
                       kMaxTextBytes),
           value);
    }
    return value.get<std::string>();
  }

  std::string Id(const Json& value, const std::string& element) const {
    if (value.is_number_integer()) return value.dump();
    if (!IsText(value) || value.get_ref<const std::string&>().empty()) {
      Fail(element,
           fmt::format("must be an integer or a string of 1 to {} bytes without control characters",
                       kMaxTextBytes),
           value);
    }
    return value.get<std::string>();
  }

  int VertexOf(const Json& value, const std::string& element) const {
    const auto found = index_.find(Id(value, element));
    if (found == index_.end()) Fail(element, fmt::format("no node has the id {}", Shown(value)));
    return found->second;
  }

  void ReadNodes(const Json& nodes) {
    if (!nodes.is_array()) Fail("nodes", "must be a list", nodes);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const std::string element = fmt::format("nodes[{}]", k);
      if (!nodes[k].is_object()) Fail(element, "must be an object", nodes[k]);
      const Json& id_value = Member(nodes[k], element, "id");
      const std::string id = Id(id_value, element + ".id");
      const auto [first, is_new] = index_.emplace(id, static_cast<int>(k));
      if (!is_new) {
        Fail(element + ".id", fmt::format("must differ from the id of nodes[{}]", first->second),
             id_value);
      }
      const Json& pos = Member(nodes[k], element, "pos");
      if (!pos.is_array() || pos.size() != 2) {
        Fail(element + ".pos", "must be a list of two numbers, x and y in metres", pos);
      }
      data_.vertex_ids.push_back(id);
      data_.positions.push_back(
          {FiniteNumber(pos[0], element + ".pos[0]"), FiniteNumber(pos[1], element + ".pos[1]")});
      data_.priorities.push_back(Priority(nodes[k], element));
    }
  }

  void ReadLinks(const Json& root) {
    if (root.contains("links") && root.contains("edges")) {
      Fail("the file", "must have either `links` or `edges`, got both");
    }
    const char* const key = root.contains("edges") ? "edges" : "links";
    const Json& links = Member(root, "", key);
    if (!links.is_array()) Fail(key, "must be a list", links);
    bool directed = false;
    if (const auto found = root.find("directed"); found != root.end()) {
      if (!found->is_boolean()) Fail("directed", "must be true or false", *found);
      directed = found->get<bool>();
    }
    for (std::size_t k = 0; k < links.size(); ++k) {
      ReadLink(links[k], fmt::format("{}[{}]", key, k), directed);
    }
    if (directed) JoinArcs();
  }

  /// Puts the link into data_.edges; the same pair again only shortens the edge.
  void ReadLink(const Json& link, const std::string& element, bool directed) {
    if (!link.is_object()) Fail(element, "must be an object", link);
    const int source = VertexOf(Member(link, element, "source"), element + ".source");
    const int target = VertexOf(Member(link, element, "target"), element + ".target");
    if (source == target) {
      Fail(element, "the ends must differ", link.at("target"));
    }
    const double length_m = LengthOf(link, element, source, target);
    const auto ends = directed ? std::pair(source, target)
                               : std::pair(std::min(source, target), std::max(source, target));
    const auto [place, is_new] = edge_of_.emplace(ends, data_.edges.size());
    if (is_new) {
      data_.edges.push_back({source, target, length_m});
      elements_.push_back(element);
      return;
    }
    Warn(fmt::format("{}: a parallel edge between {} and {}; the shortest is kept", element,
                     data_.vertex_ids[source], data_.vertex_ids[target]));
    Edge& edge = data_.edges[place->second];
    edge.length_m = std::min(edge.length_m, length_m);
  }

  double LengthOf(const Json& link, const std::string& element, int source, int target) {
    if (const auto found = link.find("length"); found != link.end()) {
      return PositiveNumber(*found, element + ".length");
    }
    if (length_source_ == EdgeLengthSource::kFile) {
      Fail(element, "must have `length`, since lengths are to come from the file");
    }
    const double length_m = Distance_m(data_.positions[source], data_.positions[target]);
    if (length_m >= kSamePoint_m) return length_m;
    Warn(
        fmt::format("{}: nodes {} and {} stand on the same point; their edge is taken as 1 mm "
                    "long",
                    element, data_.vertex_ids[source], data_.vertex_ids[target]));
    return kSamePoint_m;
  }

  /// A directed file must give both arcs of each edge, with one length.
  void JoinArcs() {
    constexpr double kTolerance = 1e-6;
    std::vector<Edge> edges;
    for (std::size_t e = 0; e < data_.edges.size(); ++e) {
      const Edge& arc = data_.edges[e];
      const auto opposite = edge_of_.find({arc.target, arc.source});
      if (opposite == edge_of_.end()) {
        Fail(elements_[e], fmt::format("a directed file must have both arcs of each edge, got none "
                                       "from {} to {}",
                                       data_.vertex_ids[arc.target], data_.vertex_ids[arc.source]));
      }
      const double opposite_m = data_.edges[opposite->second].length_m;
      if (std::abs(opposite_m - arc.length_m) > kTolerance * arc.length_m) {
        Fail(elements_[e], fmt::format("both arcs of an edge must have one length, got {} and {}",
                                       arc.length_m, opposite_m));
      }
      if (e < opposite->second) edges.push_back(arc);
    }
    data_.edges = std::move(edges);
  }

  void ReadGraphAttributes(const Json& attributes) {
    if (!attributes.is_object()) Fail("graph", "must be an object", attributes);
    for (const auto& [key, value] : attributes.items()) {
      if (key == "name") data_.name = Text(value, "graph.name");
      if (key == "source") data_.source = Text(value, "graph.source");
      if (key == "metres_per_px") {
        data_.metres_per_px = PositiveNumber(value, "graph.metres_per_px");
      }
      if (key == "shortest_closed_walk" && !value.is_null()) ReadClosedWalk(value);
    }
  }

  void ReadClosedWalk(const Json& value) {
    const std::string element = "graph.shortest_closed_walk";
    if (!value.is_object()) Fail(element, "must be an object", value);
    ClosedWalk walk;
    walk.length_m = PositiveNumber(Member(value, element, "length_m"), element + ".length_m");
    walk.source = Text(Member(value, element, "source"), element + ".source");
    const Json& vertices = Member(value, element, "vertices");
    if (!vertices.is_array()) Fail(element + ".vertices", "must be a list", vertices);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      walk.vertices.push_back(VertexOf(vertices[k], fmt::format("{}.vertices[{}]", element, k)));
    }
    data_.shortest_closed_walk = std::move(walk);
  }

  const std::string& file_;
  EdgeLengthSource length_source_;
  std::vector<std::string>& warnings_;
  GraphData data_;
  std::unordered_map<std::string, int> index_;          // of a vertex, by its id
  std::map<std::pair<int, int>, std::size_t> edge_of_;  // by ends; ascending if undirected
  std::vector<std::string> elements_;                   // of each edge, as errors name it
};

}  // namespace

GraphData ParseNodeLink(std::string_view text, const std::string& file,
                        EdgeLengthSource length_source, std::vector<std::string>& warnings) {
  return NodeLinkParser(file, length_source, warnings).Parse(ParseJson(text, file));
}

}  // namespace ronda
