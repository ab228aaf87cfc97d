// libFuzzer's target for a reader of maps. The input is the content of a file that is called
// RONDA_FUZZED_FILE, whose ending says which reader it is for.
//
// What the reader accepts, the node-link writer writes and the reader reads back to the same graph;
// what it refuses, it refuses by an InputError. Errors and warnings are one short line each that
// names the file. Anything else ends the process: another exception, a failed check, a sanitiser,
// too much memory or time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/check.h"
#include "common/base/error.h"
#include "common/world/graph_file.h"

namespace ronda {
namespace {

/// For people and terminals: one line, not long, that begins with the file's name.
void CheckMessage(const std::string& message) {
  constexpr std::size_t kMostBytes = 1000;
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7f; };
  RONDA_CHECK(message.starts_with(RONDA_FUZZED_FILE ":"), "{}", message);
  RONDA_CHECK(message.size() <= kMostBytes, "{} bytes: {}", message.size(), message);
  RONDA_CHECK(std::ranges::none_of(message, is_control), "{}", message);
}

std::optional<PatrolGraph> Parse(std::string_view text, EdgeLengthSource length_source) {
  try {
    std::vector<std::string> warnings;
    PatrolGraph graph = ParseGraphFile(text, RONDA_FUZZED_FILE, length_source, &warnings);
    for (const std::string& warning : warnings) CheckMessage(warning);
    return graph;
  } catch (const InputError& error) {
    CheckMessage(error.what());
    return std::nullopt;
  }
}

void CheckUsable(const PatrolGraph& graph) {
  RONDA_CHECK(std::isfinite(graph.mean_edge_length_m()) && graph.mean_edge_length_m() > 0.0,
              "mean edge {} m", graph.mean_edge_length_m());
}

void CheckSameWalk(const std::optional<ClosedWalk>& a, const std::optional<ClosedWalk>& b) {
  RONDA_CHECK(a.has_value() == b.has_value(), "a closed walk: {}, {}", a.has_value(),
              b.has_value());
  if (!a) return;
  RONDA_CHECK(a->vertices == b->vertices, "the closed walks differ");
  RONDA_CHECK(a->length_m == b->length_m, "{} m, {} m", a->length_m, b->length_m);
  RONDA_CHECK(a->source == b->source, "'{}', '{}'", a->source, b->source);
}

void CheckSame(const PatrolGraph& a, const PatrolGraph& b) {
  constexpr double kTolerance = 1e-12;  // relative: a length that is the distance is not written
  RONDA_CHECK(a.name() == b.name(), "'{}', '{}'", a.name(), b.name());
  RONDA_CHECK(a.source() == b.source(), "'{}', '{}'", a.source(), b.source());
  RONDA_CHECK(a.metres_per_px() == b.metres_per_px(), "{}, {}", a.metres_per_px(),
              b.metres_per_px());
  RONDA_CHECK(a.vertex_count() == b.vertex_count(), "{}, {}", a.vertex_count(), b.vertex_count());
  for (int v = 0; v < a.vertex_count(); ++v) {
    RONDA_CHECK(a.vertex_id(v) == b.vertex_id(v), "'{}', '{}'", a.vertex_id(v), b.vertex_id(v));
    const Position& at = a.positions()[v];
    RONDA_CHECK(at.x_m == b.positions()[v].x_m && at.y_m == b.positions()[v].y_m, "vertex {}", v);
  }
  RONDA_CHECK(a.edge_count() == b.edge_count(), "{}, {}", a.edge_count(), b.edge_count());
  for (int e = 0; e < a.edge_count(); ++e) {
    const Edge& edge = a.edges()[e];
    const Edge& again = b.edges()[e];
    RONDA_CHECK(edge.source == again.source && edge.target == again.target, "edge {}", e);
    RONDA_CHECK(std::abs(edge.length_m - again.length_m) <= kTolerance * edge.length_m,
                "edge {}: {} m, {} m", e, edge.length_m, again.length_m);
  }
  CheckSameWalk(a.shortest_closed_walk(), b.shortest_closed_walk());
}

void CheckReader(std::string_view input) {
  for (const auto length_source : {EdgeLengthSource::kEuclidean, EdgeLengthSource::kFile}) {
    const auto graph = Parse(input, length_source);
    if (!graph) continue;
    CheckUsable(*graph);
    std::vector<std::string> warnings;
    CheckSame(*graph, ParseGraphFile(NodeLinkText(*graph), "written.json",
                                     EdgeLengthSource::kEuclidean, &warnings));
    RONDA_CHECK(warnings.empty(), "{}", warnings.front());
  }
}

}  // namespace
}  // namespace ronda

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ronda::CheckReader({reinterpret_cast<const char*>(data), size});
  return 0;
}
