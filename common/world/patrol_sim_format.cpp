#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "common/base/error.h"
#include "common/world/map_formats.h"

namespace ronda {
namespace {

/// The text's tokens, each with its line.
class Tokens {
 public:
  Tokens(std::string_view text, const std::string& file_name)
      : rest_(text), file_name_(file_name) {}

  /// Where the last token stood: "FILE:LINE".
  std::string Place() const { return fmt::format("{}:{}", file_name_, line_); }

  [[noreturn]] void Refuse(const std::string& rule) const {
    throw InputError(fmt::format("{}: {}", Place(), rule));
  }

  std::string_view Next(std::string_view what) {
    const auto token = TryNext();
    if (!token) Refuse(fmt::format("the file ends where {} is expected", what));
    return *token;
  }

  std::optional<std::string_view> TryNext() {
    while (!rest_.empty() && IsSpace(rest_.front())) {
      if (rest_.front() == '\n') ++line_;
      rest_.remove_prefix(1);
    }
    if (rest_.empty()) return std::nullopt;
    std::size_t length = 0;
    while (length < rest_.size() && !IsSpace(rest_[length])) ++length;
    const auto token = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return token;
  }

  double Number(std::string_view what) {
    const auto token = Next(what);
    double value = 0.0;
    const auto digits = token.starts_with('+') ? token.substr(1) : token;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
      Refuse(fmt::format("{} must be a finite number, got '{}'", what, token));
    }
    return value;
  }

  int Count(std::string_view what, int at_least, int at_most) {
    const double value = Number(what);
    if (value != std::floor(value) || value < at_least || value > at_most) {
      Refuse(fmt::format("{} must be a whole number from {} to {}, got {}", what, at_least, at_most,
                         value));
    }
    return static_cast<int>(value);
  }

 private:
  static bool IsSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  std::string_view rest_;
  std::string file_name_;
  int line_ = 1;
};

struct Arc {
  int target = 0;
  double cost_px = 0.0;
  std::string place;
};

}  // namespace

GraphData ParsePatrolSimGraph(std::string_view text, const std::string& file_name,
                              EdgeLengthSource length_source, std::vector<std::string>& warnings) {
  constexpr int kMost = 100'000;
  Tokens tokens(text, file_name);
  GraphData data;
  data.name = file_name;
  const int vertex_count = tokens.Count("the number of vertices", 1, kMost);
  tokens.Number("the width in px");
  tokens.Number("the height in px");
  data.metres_per_px = tokens.Number("the resolution in metres per px");
  if (data.metres_per_px <= 0.0) {
    tokens.Refuse(
        fmt::format("the resolution in metres per px must be > 0, got {}", data.metres_per_px));
  }
  const double offset_x_m = tokens.Number("the offset x in metres");
  const double offset_y_m = tokens.Number("the offset y in metres");

  std::vector<std::vector<Arc>> arcs;
  for (int v = 0; v < vertex_count; ++v) {
    const int id = tokens.Count(fmt::format("the id of vertex no. {}", v), 0, kMost);
    if (id != v) {
      tokens.Refuse(
          fmt::format("vertex ids count from 0 in order, each once: expected {}, got {}", v, id));
    }
    const double x_px = tokens.Number(fmt::format("x of vertex {}", v));
    const double y_px = tokens.Number(fmt::format("y of vertex {}", v));
    data.vertex_ids.push_back(std::to_string(id));
    data.positions.push_back(
        {x_px * data.metres_per_px + offset_x_m, y_px * data.metres_per_px + offset_y_m});
    const int degree =
        tokens.Count(fmt::format("the number of neighbours of vertex {}", v), 0, kMost);
    arcs.emplace_back();
    for (int k = 0; k < degree; ++k) {
      Arc arc;
      arc.target = tokens.Count(fmt::format("neighbour no. {} of vertex {}", k, v), 0, kMost);
      arc.place = tokens.Place();
      if (arc.target >= vertex_count) {
        tokens.Refuse(fmt::format("vertex {} lists neighbour {}, but there are {} vertices", v,
                                  arc.target, vertex_count));
      }
      if (arc.target == v) tokens.Refuse(fmt::format("vertex {} lists itself as neighbour", v));
      tokens.Next(fmt::format("the compass word of neighbour {} of vertex {}", arc.target, v));
      arc.cost_px =
          tokens.Number(fmt::format("the cost of neighbour {} of vertex {}", arc.target, v));
      if (arc.cost_px < 0.0 || (arc.cost_px == 0.0 && length_source == EdgeLengthSource::kFile)) {
        tokens.Refuse(
            fmt::format("the cost of neighbour {} of vertex {} must be {} 0, got {}", arc.target, v,
                        length_source == EdgeLengthSource::kFile ? ">" : "≥", arc.cost_px));
      }
      for (const Arc& other : arcs.back()) {
        if (other.target == arc.target) {
          warnings.push_back(
              fmt::format("{}: vertex {} lists neighbour {} twice", arc.place, v, arc.target));
        }
      }
      arcs.back().push_back(arc);
    }
  }
  if (const auto extra = tokens.TryNext()) {
    tokens.Refuse(
        fmt::format("the file must end after {} vertices, got '{}'", vertex_count, *extra));
  }

  std::vector<Edge> edges;
  for (int v = 0; v < vertex_count; ++v) {
    for (const Arc& arc : arcs[v]) {
      const auto& back = arcs[arc.target];
      const bool both_ways = std::any_of(back.begin(), back.end(),
                                         [&](const Arc& other) { return other.target == v; });
      if (!both_ways) {
        warnings.push_back(fmt::format(
            "{}: vertex {} lists neighbour {}, but {} does not list {}; taken both ways", arc.place,
            v, arc.target, arc.target, v));
      }
      const Position from = data.positions[v];
      const Position to = data.positions[arc.target];
      const double length_m = length_source == EdgeLengthSource::kFile
                                  ? arc.cost_px * data.metres_per_px
                                  : std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
      edges.push_back({v, arc.target, length_m});
    }
  }
  data.edges = MergeEdges(data, std::move(edges), true, file_name, warnings);
  return data;
}

}  // namespace ronda
