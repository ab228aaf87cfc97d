#include "common/world/closed_walk.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "common/base/rng.h"

namespace ronda {
namespace {

constexpr double kGainM = 1e-9;  // smaller gains are rounding

/// A cyclic order of all vertices on the metric closure, improved in place.
class Tour {
 public:
  Tour(const ShortestPaths& paths, std::vector<int> order)
      : paths_(paths), order_(std::move(order)) {}

  void Improve() {
    while (TwoOpt() || OrOpt()) {
    }
  }

  double LengthM() const {
    double length_m = 0.0;
    for (int i = 0; i < size(); ++i) length_m += Between(i, i + 1);
    return length_m;
  }

  const std::vector<int>& order() const { return order_; }

 private:
  int size() const { return static_cast<int>(order_.size()); }
  int At(int i) const { return order_[i < size() ? i : i - size()]; }
  double Between(int i, int j) const { return paths_.distance_m(At(i), At(j)); }

  /// Reverses a stretch wherever that shortens the tour.
  bool TwoOpt() {
    bool improved = false;
    for (int i = 0; i + 2 < size(); ++i) {
      for (int j = i + 2; j < size() && !(i == 0 && j == size() - 1); ++j) {
        const double gain_m = Between(i, i + 1) + Between(j, j + 1) - Between(i, j) -
                              paths_.distance_m(At(i + 1), At(j + 1));
        if (gain_m > kGainM) {
          std::reverse(order_.begin() + i + 1, order_.begin() + j + 1);
          improved = true;
        }
      }
    }
    return improved;
  }

  /// Moves a stretch of one to three vertices to another place, either way round, wherever that
  /// shortens the tour.
  bool OrOpt() {
    bool improved = false;
    for (int length = 1; length <= 3 && length + 2 <= size(); ++length) {
      for (int step = 0; step < size(); ++step) improved |= MoveFront(length);
    }
    return improved;
  }

  /// Tries to move order_[0 … length); rotates by one where it stays.
  bool MoveFront(int length) {
    const int count = size();
    const double removal_m = Between(count - 1, 0) + Between(length - 1, length) -
                             paths_.distance_m(At(count - 1), At(length));
    for (int j = length; j + 1 < count; ++j) {
      const double open_m = Between(j, j + 1);
      const double forward_m = Between(j, 0) + Between(length - 1, j + 1) - open_m;
      const double backward_m = Between(j, length - 1) + Between(0, j + 1) - open_m;
      if (removal_m - std::min(forward_m, backward_m) > kGainM) {
        if (backward_m < forward_m) std::reverse(order_.begin(), order_.begin() + length);
        std::rotate(order_.begin(), order_.begin() + length, order_.begin() + j + 1);
        return true;
      }
    }
    std::rotate(order_.begin(), order_.begin() + 1, order_.end());
    return false;
  }

  const ShortestPaths& paths_;
  std::vector<int> order_;
};

std::vector<int> NearestNeighbourOrder(const ShortestPaths& paths, int start) {
  std::vector<int> order{start};
  std::vector<char> used(static_cast<std::size_t>(paths.vertex_count()), 0);
  used[start] = 1;
  while (static_cast<int>(order.size()) < paths.vertex_count()) {
    int nearest = -1;
    for (int v = 0; v < paths.vertex_count(); ++v) {
      if (!used[v] && (nearest < 0 || paths.distance_m(order.back(), v) <
                                          paths.distance_m(order.back(), nearest))) {
        nearest = v;
      }
    }
    used[nearest] = 1;
    order.push_back(nearest);
  }
  return order;
}

/// Cuts the tour at three random places and swaps the middle parts (the double bridge of Martin,
/// Otto & Felten 1991).
std::vector<int> DoubleBridge(const std::vector<int>& order, Rng& rng) {
  const auto count = static_cast<std::uint32_t>(order.size());
  std::array<std::ptrdiff_t, 3> cuts{};
  for (auto& cut : cuts) cut = 1 + rng.Below(count - 1);
  std::sort(cuts.begin(), cuts.end());
  std::vector<int> kicked(order.begin(), order.begin() + cuts[0]);
  kicked.insert(kicked.end(), order.begin() + cuts[1], order.begin() + cuts[2]);
  kicked.insert(kicked.end(), order.begin() + cuts[0], order.begin() + cuts[1]);
  kicked.insert(kicked.end(), order.begin() + cuts[2], order.end());
  return kicked;
}

/// From a tour on the metric closure to a walk along edges.
ClosedWalk Expand(const ShortestPaths& paths, const std::vector<int>& order) {
  ClosedWalk walk;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int to = order[(i + 1) % order.size()];
    for (int v = order[i]; v != to; v = paths.next_hop(v, to)) walk.vertices.push_back(v);
    walk.length_m += paths.distance_m(order[i], to);
  }
  return walk;
}

}  // namespace

ClosedWalk FindShortClosedWalk(const PatrolGraph& graph, const ShortestPaths& paths,
                               std::uint64_t seed) {
  const int count = graph.vertex_count();
  Rng rng = SplitSeed(seed, 0);
  // Local searches cost about count², so large maps get fewer.
  const int starts = std::clamp(20'000 / (count * count) + 1, 1, 20);
  const int kicks = std::clamp(4'000'000 / (count * count), 1, 2000);
  std::vector<int> best;
  double best_m = std::numeric_limits<double>::infinity();
  for (int start = 0; start < starts; ++start) {
    Tour tour(paths, NearestNeighbourOrder(
                         paths, static_cast<int>(rng.Below(static_cast<std::uint32_t>(count)))));
    tour.Improve();
    std::vector<int> current = tour.order();
    double current_m = tour.LengthM();
    for (int kick = 0; kick < kicks && count >= 8; ++kick) {
      Tour kicked(paths, DoubleBridge(current, rng));
      kicked.Improve();
      if (kicked.LengthM() <= current_m) {
        current_m = kicked.LengthM();
        current = kicked.order();
      }
    }
    if (current_m < best_m - kGainM) {
      best_m = current_m;
      best = current;
    }
  }
  ClosedWalk walk = Expand(paths, best);
  walk.source = "upper value: best of many 2-opt/Or-opt local searches";
  return walk;
}

ClosedWalk ClosedWalkOf(const PatrolGraph& graph, const ShortestPaths& paths) {
  if (graph.shortest_closed_walk()) return *graph.shortest_closed_walk();
  return FindShortClosedWalk(graph, paths, 1);
}

}  // namespace ronda
