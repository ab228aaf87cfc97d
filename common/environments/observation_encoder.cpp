#include "common/environments/observation_encoder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "common/base/error.h"

namespace ronda {
namespace {

struct Scheme {
  const char* name;
  const char* schema;  // changes when the meaning of a number does
};

constexpr Scheme kCandidates{"candidates", "patrol-candidates-26"};
constexpr Scheme kThesis{"thesis", "patrol-sorted-vertices-3"};

std::variant<CandidateFeatures, SortedVertices> MakeScheme(const std::string& name,
                                                           const PatrolGraph& graph,
                                                           const ShortestPaths& paths) {
  if (name == kCandidates.name) return CandidateFeatures(graph, paths);
  if (name == kThesis.name) return SortedVertices(graph, paths);
  throw InputError(fmt::format("no observation is called '{}'; there are {}", name,
                               fmt::join(ObservationEncoder::Names(), ", ")));
}

}  // namespace

ObservationEncoder::ObservationEncoder(const std::string& scheme, const PatrolGraph& graph,
                                       const ShortestPaths& paths)
    : graph_(graph), scheme_(MakeScheme(scheme, graph, paths)) {
  const auto vertices = static_cast<std::uint32_t>(graph.vertex_count());
  const auto degree = static_cast<std::uint32_t>(graph.max_degree());
  if (features() > 0) {
    schema_ = kCandidates.schema;
    shape_ = {.observation_size = degree * CandidateFeatures::kFeatures,
              .num_actions = degree,
              .extras_size = 0};
  } else {
    schema_ = kThesis.schema;
    shape_ = {.observation_size = 3 * vertices, .num_actions = vertices, .extras_size = 0};
  }
}

std::string ObservationEncoder::SchemeOf(const std::string& schema) {
  for (const Scheme& scheme : {kCandidates, kThesis}) {
    if (schema == scheme.schema) return scheme.name;
  }
  throw InputError(fmt::format("no observation has the schema '{}'", schema));
}

int ObservationEncoder::features() const {
  return std::holds_alternative<CandidateFeatures>(scheme_) ? CandidateFeatures::kFeatures : 0;
}

void ObservationEncoder::Encode(const PatrolWorld& world, int robot, std::span<float> observation,
                                std::span<std::uint8_t> legal_actions) {
  if (const auto* candidates = std::get_if<CandidateFeatures>(&scheme_)) {
    const int degree = graph_.degree(world.target(robot));
    std::fill(observation.begin() + degree * CandidateFeatures::kFeatures, observation.end(), 0.0f);
    std::fill(legal_actions.begin(), legal_actions.end(), std::uint8_t{0});
    std::fill_n(legal_actions.begin(), degree, std::uint8_t{1});
    candidates->Encode(world, robot, scratch_, observation);
  } else {
    std::get<SortedVertices>(scheme_).Encode(world, robot, observation, legal_actions);
  }
}

int ObservationEncoder::NextVertex(int vertex, int action) const {
  if (const auto* sorted = std::get_if<SortedVertices>(&scheme_)) {
    return sorted->NextVertex(vertex, action);
  }
  return graph_.neighbours(vertex)[action];
}

}  // namespace ronda
