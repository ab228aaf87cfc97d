#include "common/environments/observation_encoder.h"

#include <fmt/format.h>

#include "common/base/error.h"

namespace ronda {
namespace {

std::variant<CandidateEncoder, ThesisEncoder> MakeEncoder(const PatrolGraph& graph,
                                                          const ShortestPaths& paths,
                                                          ObservationScheme scheme) {
  if (scheme == ObservationScheme::kThesis) return ThesisEncoder(graph, paths);
  return CandidateEncoder(graph, paths);
}

}  // namespace

ObservationScheme ParseObservationScheme(const std::string& name) {
  for (const auto scheme : {ObservationScheme::kCandidates, ObservationScheme::kThesis}) {
    if (name == Name(scheme)) return scheme;
  }
  throw UsageError(
      fmt::format("the observation must be one of candidates, thesis, got '{}'", name));
}

std::string_view Name(ObservationScheme scheme) {
  return scheme == ObservationScheme::kCandidates ? "candidates" : "thesis";
}

std::string_view Schema(ObservationScheme scheme) {
  return scheme == ObservationScheme::kCandidates ? "patrol-candidates-26" : "patrol-thesis-3";
}

ObservationScheme SchemeOf(const std::string& schema) {
  for (const auto scheme : {ObservationScheme::kCandidates, ObservationScheme::kThesis}) {
    if (schema == Schema(scheme)) return scheme;
  }
  throw InputError(fmt::format("no observation here has the schema '{}'", schema));
}

ObservationEncoder::ObservationEncoder(const PatrolGraph& graph, const ShortestPaths& paths,
                                       ObservationScheme scheme)
    : encoder_(MakeEncoder(graph, paths, scheme)) {}

int ObservationEncoder::observation_size() const {
  return std::visit([](const auto& encoder) { return encoder.observation_size(); }, encoder_);
}

int ObservationEncoder::num_actions() const {
  return std::visit([](const auto& encoder) { return encoder.num_actions(); }, encoder_);
}

int ObservationEncoder::features_per_candidate() const {
  return scheme() == ObservationScheme::kCandidates ? CandidateEncoder::kFeatures : 0;
}

void ObservationEncoder::Encode(const PatrolWorld& world, int robot, std::span<float> observation,
                                std::span<std::uint8_t> legal_actions) {
  std::visit([&](auto& encoder) { encoder.Encode(world, robot, observation, legal_actions); },
             encoder_);
}

int ObservationEncoder::NextVertex(int vertex, int action) const {
  return std::visit([&](const auto& encoder) { return encoder.NextVertex(vertex, action); },
                    encoder_);
}

}  // namespace ronda
