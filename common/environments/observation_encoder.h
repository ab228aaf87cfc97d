#pragma once
// What a robot that has arrived sees, as numbers, and what its actions mean: one of the schemes by
// name.
//
// `candidates`: CandidateFeatures, one row for each neighbour, padded with zeros to the map's
// largest degree; action k is the k-th neighbour. `thesis`: SortedVertices. The graph must outlive
// the encoder. Encode allocates nothing once warm. Thread-compatible.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>

#include "common/environments/candidate_features.h"
#include "common/environments/sorted_vertices.h"
#include "common/rl/transition.h"

namespace ronda {

class ObservationEncoder {
 public:
  /// `scheme`: one of Names(), else InputError that lists them.
  ObservationEncoder(const std::string& scheme, const PatrolGraph& graph,
                     const ShortestPaths& paths);

  static std::vector<std::string> Names() { return {"candidates", "thesis"}; }
  /// The scheme that a network of this schema reads; InputError where none does.
  static std::string SchemeOf(const std::string& schema);

  TransitionShape shape() const { return shape_; }
  int features() const;  // of one candidate; 0 where the observation is not made of candidates
  const std::string& schema() const {
    return schema_;
  }  // names the meaning of the numbers; a network remembers it

  /// observation (O) and legal actions (A) of a robot that stands at its target.
  void Encode(const PatrolWorld& world, int robot, std::span<float> observation,
              std::span<std::uint8_t> legal_actions);
  /// The vertex that an action leads to from `vertex`.
  int NextVertex(int vertex, int action) const;

 private:
  const PatrolGraph& graph_;
  TransitionShape shape_;
  std::string schema_;
  std::variant<CandidateFeatures, SortedVertices> scheme_;
  CandidateFeatures::Scratch scratch_;
};

}  // namespace ronda
