#include "common/world/dot_graph_file.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "common/base/error.h"
#include "common/world/shown_text.h"

namespace ronda {
namespace {

constexpr int kMaxNeighbours = 1 << 20;

std::string Shown(std::string_view token) { return "'" + ShownText(token, 40) + "'"; }

/// Splits at white space and keeps count of lines.
class TokenReader {
 public:
  TokenReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// Of the last token, from 1.
  int line() const { return line_; }
  const std::string& file() const { return file_; }

  std::optional<std::string_view> Next() {
    while (at_ < text_.size() && IsSpace(text_[at_])) {
      if (text_[at_++] == '\n') ++line_;
    }
    if (at_ == text_.size()) return std::nullopt;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !IsSpace(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  [[noreturn]] void Fail(const std::string& rule, const std::string& got) const {
    throw InputError(fmt::format("{}:{}: {}, got {}", file_, line_, rule, got));
  }

  std::string_view Word(const std::string& rule) {
    const auto token = Next();
    if (!token) Fail(rule, "the end of the file");
    return *token;
  }

  int Integer(int min, int max, const std::string& what) {
    const std::string rule = max == std::numeric_limits<int>::max()
                                 ? fmt::format("{} must be an integer of at least {}", what, min)
                                 : fmt::format("{} must be an integer in {} … {}", what, min, max);
    const std::string_view token = Word(rule);
    int value = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (error != std::errc() || end != token.data() + token.size() || value < min || value > max) {
      Fail(rule, Shown(token));
    }
    return value;
  }

  double Number(const std::string& what) { return Number(what, "a finite number", Any); }
  double NumberAtLeastZero(const std::string& what) {
    return Number(what, "a finite number of at least 0", [](double x) { return x >= 0.0; });
  }
  double PositiveNumber(const std::string& what) {
    return Number(what, "a positive finite number", [](double x) { return x > 0.0; });
  }

 private:
  static bool IsSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
  static bool Any(double) { return true; }

  double Number(const std::string& what, const char* kind, bool (*accepts)(double)) {
    const std::string rule = fmt::format("{} must be {}", what, kind);
    const std::string_view token = Word(rule);
    double value = 0.0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (error != std::errc() || end != token.data() + token.size() || !std::isfinite(value) ||
        !accepts(value)) {
      Fail(rule, Shown(token));
    }
    return value;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

struct Arc {
  double cost_px = 0.0;
  int line = 0;
};
using Arcs = std::map<std::pair<int, int>, Arc>;  // by (from, to)

struct PixelPoint {
  double x_px = 0.0;
  double y_px = 0.0;
};

class DotGraphParser {
 public:
  DotGraphParser(std::string_view text, const std::string& file, EdgeLengthSource length_source,
                 std::vector<std::string>& warnings)
      : tokens_(text, file), length_source_(length_source), warnings_(warnings) {}

  GraphData Parse() {
    vertex_count_ = tokens_.Integer(2, PatrolGraph::kMaxVertices, "the number of vertices");
    tokens_.Number("the width");
    tokens_.Number("the height");
    data_.metres_per_px = tokens_.PositiveNumber("metres per px");
    offset_.x_m = tokens_.Number("the offset x");
    offset_.y_m = tokens_.Number("the offset y");
    for (int vertex = 0; vertex < vertex_count_; ++vertex) ReadVertex(vertex);
    if (const auto token = tokens_.Next()) {
      tokens_.Fail(fmt::format("the file must end after its {} vertices", vertex_count_),
                   Shown(*token));
    }
    JoinArcs();
    return std::move(data_);
  }

 private:
  void Warn(int line, const std::string& what) {
    warnings_.push_back(fmt::format("{}:{}: {}", tokens_.file(), line, what));
  }

  void ReadVertex(int vertex) {
    const std::string rule = fmt::format("the id of vertex {0} must be {0} (in order)", vertex);
    const std::string_view id = tokens_.Word(rule);
    if (id != std::to_string(vertex)) tokens_.Fail(rule, Shown(id));
    const std::string name = fmt::format("vertex {}", vertex);
    const double x_px = tokens_.Number(name + ": x");
    const double y_px = tokens_.Number(name + ": y");
    points_.push_back({x_px, y_px});
    data_.vertex_ids.push_back(std::to_string(vertex));
    data_.positions.push_back(
        {x_px * data_.metres_per_px + offset_.x_m, y_px * data_.metres_per_px + offset_.y_m});
    const int neighbours =
        tokens_.Integer(0, kMaxNeighbours, name + ": the number of its neighbours");
    for (int k = 0; k < neighbours; ++k) ReadArc(vertex);
  }

  void ReadArc(int vertex) {
    const std::string name = fmt::format("vertex {}", vertex);
    const int neighbour = tokens_.Integer(0, vertex_count_ - 1, name + ": a neighbour's id");
    const int line = tokens_.line();
    if (neighbour == vertex) {
      tokens_.Fail(name + ": a neighbour must be another vertex", std::to_string(neighbour));
    }
    const std::string rule =
        fmt::format("{}: a compass word must follow neighbour {}", name, neighbour);
    const std::string_view word = tokens_.Word(rule);
    if (std::isalpha(static_cast<unsigned char>(word[0])) == 0) tokens_.Fail(rule, Shown(word));
    const double cost_px =
        tokens_.NumberAtLeastZero(fmt::format("{}: the cost to neighbour {}", name, neighbour));
    const auto [arc, is_new] = arcs_.try_emplace({vertex, neighbour}, Arc{cost_px, line});
    if (!is_new) {
      Warn(line, fmt::format("{} lists neighbour {} more than once; {}", name, neighbour,
                             length_source_ == EdgeLengthSource::kFile ? "the shortest is kept"
                                                                       : "one is kept"));
      arc->second.cost_px = std::min(arc->second.cost_px, cost_px);
    }
  }

  /// Each pair of arcs becomes an edge; an arc without its opposite does so alone.
  void JoinArcs() {
    for (const auto& [ends, arc] : arcs_) {
      const auto [from, to] = ends;
      const auto opposite = arcs_.find({to, from});
      if (opposite == arcs_.end()) {
        Warn(arc.line, fmt::format("the arc from {0} to {1} is one-way; it is taken both ways "
                                   "(vertex {1} does not list {0})",
                                   from, to));
        data_.edges.push_back({from, to, LengthOf(from, to, arc.cost_px, arc.line)});
      } else if (from < to) {
        const double other_px = opposite->second.cost_px;
        if (length_source_ == EdgeLengthSource::kFile && other_px != arc.cost_px) {
          Warn(arc.line, fmt::format("the costs between {} and {} differ ({} and {}); the smaller "
                                     "is kept",
                                     from, to, arc.cost_px, other_px));
        }
        data_.edges.push_back(
            {from, to, LengthOf(from, to, std::min(arc.cost_px, other_px), arc.line)});
      }
    }
  }

  double LengthOf(int from, int to, double cost_px, int line) {
    if (length_source_ == EdgeLengthSource::kFile) {
      if (cost_px > 0.0) return cost_px * data_.metres_per_px;
      Warn(line, fmt::format("the cost between {} and {} is 0; their edge is taken as 1 mm long",
                             from, to));
      return kSamePoint_m;
    }
    const double length_m =
        std::hypot(points_[from].x_px - points_[to].x_px, points_[from].y_px - points_[to].y_px) *
        data_.metres_per_px;
    if (length_m >= kSamePoint_m) return length_m;
    Warn(line, fmt::format("vertices {} and {} stand on the same point; their edge is taken as "
                           "1 mm long",
                           from, to));
    return kSamePoint_m;
  }

  TokenReader tokens_;
  EdgeLengthSource length_source_;
  std::vector<std::string>& warnings_;
  GraphData data_;
  Position offset_;
  int vertex_count_ = 0;
  std::vector<PixelPoint> points_;  // (V): lengths from px, so that equal ones stay equal
  Arcs arcs_;
};

}  // namespace

GraphData ParseDotGraph(std::string_view text, const std::string& file,
                        EdgeLengthSource length_source, std::vector<std::string>& warnings) {
  return DotGraphParser(text, file, length_source, warnings).Parse();
}

}  // namespace ronda
