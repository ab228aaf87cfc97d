#pragma once
// What a robot sees when it must decide, and which vertex an action means: one of the observation
// schemes, chosen by name.
//
//   name        what it is                                                  O         source
//   candidates  26 features of each neighbour (candidate_encoder.h)         26 A      ours
//   thesis      as sorted, and when the nearest other robot can be there    3 V       ours
//   sorted      distances, ascending, and idleness in that order            2 V       §3.3
//   ranking     as sorted, the idleness as its rank / V                     2 V       §4.4.1
//   normalised  as sorted, the idleness between its least and most          2 V       §4.4.2
//   centred     as sorted, the idleness less its mean                       2 V       §4.4.3
//   matrix      where every robot is, and idleness (matrix_encoder.h)       (N+1) V   §4.4.4
//
// Idleness of ranking and normalised, which lies in [0, 1], can pass through the transform of §5.1
// (idleness_scale.h). Depends on the belief alone, so training and evaluation share it. A value:
// copies share their tables. Shapes, units, cost: the scheme's own header. Thread-compatible
// (scratch memory inside): one object for each thread. Source: thesis §3.3, §4.4, §5.1.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/environments/candidate_encoder.h"
#include "common/environments/matrix_encoder.h"
#include "common/environments/thesis_encoder.h"

namespace ronda {

/// What an observation makes use of.
inline constexpr Knowledge kObservedKnowledge{.visits = Knowledge::Visits::kShared,
                                              .intentions = true};

enum class ObservationScheme {
  kCandidates,
  kThesis,
  kSorted,
  kRanking,
  kNormalised,
  kCentred,
  kMatrix,
};

/// In the order of the table above.
std::vector<std::string> ObservationNames();
/// One of ObservationNames(); else UsageError that lists them.
ObservationScheme ParseObservationScheme(const std::string& name);
std::string_view Name(ObservationScheme scheme);

struct ObservationOptions {
  /// Implicit: a scheme alone is a choice.
  ObservationOptions(ObservationScheme of = ObservationScheme::kCandidates, double with_alpha = 0.0)
      : scheme(of), alpha(with_alpha) {}

  ObservationScheme scheme;
  double alpha;       // of the transform, > 1; 0: none
  int robots = 0;     // N, read by matrix only; 0: not known
  bool stay = false;  // staying put is one of the actions
};

/// What a network remembers of its observation: changes when the meaning of a number does. Holds
/// scheme, staying put and α (`patrol-normalised-2.stay.alpha-100000`).
std::string Schema(const ObservationOptions& options);
/// Scheme, staying put and α of a schema; InputError where it is none.
ObservationOptions SchemeOf(const std::string& schema);

class ObservationEncoder {
 public:
  /// `graph` must outlive it; `paths` are the graph's, and are not kept. InputError where α is not
  /// finite, not above 1 or not for this scheme, or where matrix does not know its robots.
  ObservationEncoder(const PatrolGraph& graph, const ShortestPaths& paths,
                     const ObservationOptions& options);

  const ObservationOptions& options() const { return options_; }
  int observation_size() const;  // O
  int num_actions() const;       // A
  /// Features of one candidate, where the observation is made of A rows of candidates; else 0.
  int features_per_candidate() const;
  /// The only number of robots that it can observe; 0: any.
  int team_size() const;

  /// The observation (O) and legal actions (A) of a robot that has arrived and must decide.
  void Encode(const Belief& belief, std::span<float> observation,
              std::span<std::uint8_t> legal_actions);
  /// The vertex that a legal `action` of a robot at `vertex` goes to.
  int NextVertex(int vertex, int action) const;

 private:
  ObservationOptions options_;
  std::variant<CandidateEncoder, ThesisEncoder, MatrixEncoder> encoder_;
};

}  // namespace ronda
