#pragma once
// What a robot sees when it must decide, and which vertex an action means: one of the observation
// schemes, chosen by name.
//
// Depends on the world alone, so training and evaluation share it. A value: copies share their
// tables. Shapes, units, cost and sources: the scheme's own header. Thread-compatible (scratch
// memory inside): one object for each thread.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "common/environments/candidate_encoder.h"
#include "common/environments/thesis_encoder.h"

namespace ronda {

enum class ObservationScheme { kCandidates, kThesis };

/// "candidates" or "thesis"; else UsageError that lists the names.
ObservationScheme ParseObservationScheme(const std::string& name);
std::string_view Name(ObservationScheme scheme);
/// What a network remembers of its observation: changes when the meaning of a number does.
std::string_view Schema(ObservationScheme scheme);
/// The scheme of a schema; InputError where none has it.
ObservationScheme SchemeOf(const std::string& schema);

class ObservationEncoder {
 public:
  /// `graph` must outlive it; `paths` are the graph's, and are not kept.
  ObservationEncoder(const PatrolGraph& graph, const ShortestPaths& paths,
                     ObservationScheme scheme);

  ObservationScheme scheme() const {
    return encoder_.index() == 0 ? ObservationScheme::kCandidates : ObservationScheme::kThesis;
  }
  int observation_size() const;  // O
  int num_actions() const;       // A
  /// Features of one candidate, where the observation is made of A rows of candidates; else 0.
  int features_per_candidate() const;

  /// The observation (O) and legal actions (A) of `robot`, which has arrived at world.target(robot)
  /// and waits for its next vertex.
  void Encode(const PatrolWorld& world, int robot, std::span<float> observation,
              std::span<std::uint8_t> legal_actions);
  /// The vertex that a legal `action` of a robot at `vertex` goes to.
  int NextVertex(int vertex, int action) const;

 private:
  std::variant<CandidateEncoder, ThesisEncoder> encoder_;
};

}  // namespace ronda
