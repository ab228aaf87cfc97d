#include "common/world/closed_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "common/base/rng.h"

namespace ronda {
namespace {

using Tour = std::vector<int>;  // (V), a permutation of the vertices; the last joins the first

/// Local search over tours of the metric closure.
class TourSearch {
 public:
  TourSearch(const ShortestPaths& paths, std::uint64_t seed)
      : paths_(paths), count_(paths.vertex_count()), rng_(SplitSeed(seed, 0)) {
    for (int v = 1; v < count_; ++v) min_gain_m_ += paths_.distance_m(0, v);
    min_gain_m_ *= 1e-12;  // well above the rounding of a gain, well below any length
  }

  double Length(const Tour& tour) const {
    double length_m = Distance(tour.back(), tour.front());
    for (int k = 0; k + 1 < count_; ++k) length_m += Distance(tour[k], tour[k + 1]);
    return length_m;
  }

  /// Cheapest insertion (Rosenkrantz, Stearns & Lewis 1977), the vertices in random order.
  Tour RandomStart() {
    Tour order(count_);
    std::iota(order.begin(), order.end(), 0);
    for (int k = count_ - 1; k > 0; --k) std::swap(order[k], order[rng_.Below(k + 1)]);
    Tour tour{order[0]};
    for (int k = 1; k < count_; ++k) {
      std::size_t best = 0;
      double best_m = std::numeric_limits<double>::infinity();
      for (std::size_t p = 0; p < tour.size(); ++p) {
        const int after = tour[(p + 1) % tour.size()];
        const double added_m =
            Distance(tour[p], order[k]) + Distance(order[k], after) - Distance(tour[p], after);
        if (added_m < best_m) {
          best_m = added_m;
          best = p;
        }
      }
      tour.insert(tour.begin() + static_cast<std::ptrdiff_t>(best) + 1, order[k]);
    }
    return tour;
  }

  /// The double bridge (Martin, Otto & Felten 1991): A B C D becomes A C B D, a change that 2-opt
  /// does not undo. Needs 4 vertices or more.
  Tour Kicked(const Tour& tour) {
    int cuts[3];
    for (int& cut : cuts) cut = 1 + static_cast<int>(rng_.Below(count_ - 1));
    std::sort(std::begin(cuts), std::end(cuts));
    Tour kicked(tour);
    std::rotate(kicked.begin() + cuts[0], kicked.begin() + cuts[1], kicked.begin() + cuts[2]);
    return kicked;
  }

  void Improve(Tour& tour) const {
    bool improved = count_ > 3;
    while (improved) {
      improved = TwoOptPass(tour);
      for (int length = 1; length <= 3; ++length) improved = OrOptPass(tour, length) || improved;
    }
  }

 private:
  double Distance(int from, int to) const { return paths_.distance_m(from, to); }

  /// Reverses stretches whose two new joints are shorter than the old ones.
  bool TwoOptPass(Tour& tour) const {
    bool improved = false;
    for (int i = 0; i + 2 < count_; ++i) {
      for (int j = i + 2; j < count_; ++j) {
        const int next = tour[(j + 1) % count_];
        const double gain_m = Distance(tour[i], tour[i + 1]) + Distance(tour[j], next) -
                              Distance(tour[i], tour[j]) - Distance(tour[i + 1], next);
        if (gain_m > min_gain_m_) {
          std::reverse(tour.begin() + i + 1, tour.begin() + j + 1);
          improved = true;
        }
      }
    }
    return improved;
  }

  /// Moves segments of `length` vertices to their best other place, either way round.
  bool OrOptPass(Tour& tour, int length) const {
    if (count_ < length + 2) return false;
    bool improved = false;
    for (int i = 0; i < count_; ++i) {
      // From here the segment is tour[0 … length) and the rest is tour[length … V).
      std::rotate(tour.begin(), tour.begin() + 1, tour.end());
      improved = MoveFrontSegment(tour, length) || improved;
    }
    return improved;
  }

  bool MoveFrontSegment(Tour& tour, int length) const {
    const int first = tour[0];
    const int last = tour[length - 1];
    const double removed_m = Distance(tour[count_ - 1], first) + Distance(last, tour[length]) -
                             Distance(tour[count_ - 1], tour[length]);
    double best_m = removed_m - min_gain_m_;
    int best_place = -1;
    bool reverse = false;
    for (int j = length; j + 1 < count_; ++j) {
      const double gap_m = Distance(tour[j], tour[j + 1]);
      const double forward_m = Distance(tour[j], first) + Distance(last, tour[j + 1]) - gap_m;
      const double backward_m = Distance(tour[j], last) + Distance(first, tour[j + 1]) - gap_m;
      if (std::min(forward_m, backward_m) < best_m) {
        best_m = std::min(forward_m, backward_m);
        best_place = j;
        reverse = backward_m < forward_m;
      }
    }
    if (best_place < 0) return false;
    if (reverse) std::reverse(tour.begin(), tour.begin() + length);
    std::rotate(tour.begin(), tour.begin() + length, tour.begin() + best_place + 1);
    return true;
  }

  const ShortestPaths& paths_;
  int count_;
  Rng rng_;
  double min_gain_m_ = 0.0;
};

/// Puts the vertices of the shortest paths between the tour's stops in.
ClosedWalk Expanded(const PatrolGraph& graph, const ShortestPaths& paths, const Tour& tour) {
  ClosedWalk walk;
  for (std::size_t k = 0; k < tour.size(); ++k) {
    const int stop = tour[(k + 1) % tour.size()];
    for (int at = tour[k]; at != stop;) {
      const int next = paths.next_hop(at, stop);
      walk.vertices.push_back(at);
      walk.length_m += graph.edge_length_m(at, next);
      at = next;
    }
  }
  return walk;
}

}  // namespace

ClosedWalk FindShortestClosedWalk(const PatrolGraph& graph, const ShortestPaths& paths,
                                  std::uint64_t seed) {
  constexpr double kEffort = 8e6;  // starts · V²: an Improve is a few passes of O(V²)
  const double count = graph.vertex_count();
  const int starts = static_cast<int>(std::clamp(kEffort / (count * count), 1.0, 1000.0));
  const int kicks = count > 3 ? starts : 0;
  TourSearch search(paths, seed);
  Tour best;
  double best_m = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < starts + kicks; ++attempt) {
    Tour tour = attempt < starts ? search.RandomStart() : search.Kicked(best);
    search.Improve(tour);
    const double length_m = search.Length(tour);
    if (length_m < best_m) {
      best_m = length_m;
      best = std::move(tour);
    }
  }
  ClosedWalk walk = Expanded(graph, paths, best);
  walk.source =
      fmt::format("best of {} starts and {} kicks of 2-opt and Or-opt, seed {} (an upper value)",
                  starts, kicks, seed);
  return walk;
}

ClosedWalk ClosedWalkOf(const PatrolGraph& graph, const ShortestPaths& paths) {
  constexpr std::uint64_t kSeed = 1;
  return graph.shortest_closed_walk() ? *graph.shortest_closed_walk()
                                      : FindShortestClosedWalk(graph, paths, kSeed);
}

}  // namespace ronda
