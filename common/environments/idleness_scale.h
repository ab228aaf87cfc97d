#pragma once
// How an observation shows the vertices' idleness ζ (V numbers, by vertex), on one of four scales.
//
//   kRelative    log1p(ζ / ζ̄), at most 8                    in [0, 8]
//   kRanking     rank / V, the most idle 1                   in (0, 1]   thesis §4.4.1
//   kNormalised  (ζ − ζmin)/(ζmax − ζmin), 0 where all equal in [0, 1]   §4.4.2
//   kCentred     (ζ − ζ̄) / ζ̄, at most 8                      in [−1, 8]  §4.4.3
//
// ζ̄ is the present mean, floored. Ranks are a permutation of 1 … V: of equally idle vertices the
// lower index has the lower rank. The scales in [0, 1] can be bent towards the most idle by the
// transform of §5.1. No scale depends on the unit of time. O(V) a call, O(V log V) for ranks; no
// allocation. Thread-compatible.
#include <span>
#include <vector>

#include "common/world/belief.h"

namespace ronda {

/// f(x) = (α^x − 1)/(α − 1) for x in [0, 1] and α > 1: from 0 to 1, increasing, exact at both ends.
double AlphaTransform(double x, double alpha);

enum class IdlenessScale { kRelative, kRanking, kNormalised, kCentred };

class ScaledIdleness {
 public:
  /// `alpha` > 1 of the transform, or 0 for none; only with kRanking and kNormalised.
  ScaledIdleness(IdlenessScale scale, double alpha, int vertices);

  /// (V) as the robot believes it to be; valid until the next call. `floor_s` > 0 is the least ζ̄.
  std::span<const float> Observe(const Belief& belief, double floor_s);

 private:
  void Rank();
  void Normalise();

  IdlenessScale scale_;
  double alpha_;
  std::vector<int> order_;          // (V) vertices, least idle first; ranking only
  std::vector<double> idleness_s_;  // (V)
  std::vector<float> scaled_;       // (V)
};

}  // namespace ronda
