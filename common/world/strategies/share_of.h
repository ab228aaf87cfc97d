#pragma once
// The fraction of heuristic strategies, where nothing of nothing is nothing: 0/0 is 0.
namespace ronda {

/// `part` of `whole` ≥ 0; 0 where the whole is 0.
inline double ShareOf(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

}  // namespace ronda
