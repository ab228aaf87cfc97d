#include "common/world/christofides.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

namespace ronda {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Pair = std::pair<int, int>;  // of places among the vertices

/// The complete graph of the vertices, which go by their places in the list.
class Metric {
 public:
  Metric(const ShortestPaths& paths, std::span<const int> vertices)
      : paths_(paths), vertices_(vertices) {}

  int count() const { return static_cast<int>(vertices_.size()); }
  double Length(int a, int b) const { return paths_.distance_m(vertices_[a], vertices_[b]); }
  double Length(const Pair& pair) const { return Length(pair.first, pair.second); }

 private:
  const ShortestPaths& paths_;
  std::span<const int> vertices_;
};

std::vector<Pair> MinimumSpanningTree(const Metric& metric) {
  std::vector<Pair> tree;
  std::vector<int> outside;
  std::vector<int> nearest(static_cast<std::size_t>(metric.count()), 0);  // in the tree
  for (int place = 1; place < metric.count(); ++place) outside.push_back(place);
  while (!outside.empty()) {
    const auto next = std::ranges::min_element(
        outside, {}, [&](int place) { return metric.Length(place, nearest[place]); });
    const int added = *next;
    tree.emplace_back(nearest[added], added);
    outside.erase(next);
    for (const int place : outside) {
      if (metric.Length(place, added) < metric.Length(place, nearest[place])) {
        nearest[place] = added;
      }
    }
  }
  return tree;
}

std::vector<int> OddPlaces(const std::vector<Pair>& edges, int count) {
  std::vector<int> degrees(static_cast<std::size_t>(count), 0);
  for (const auto& [a, b] : edges) {
    ++degrees[a];
    ++degrees[b];
  }
  std::vector<int> odd;
  for (int place = 0; place < count; ++place) {
    if (degrees[place] % 2 == 1) odd.push_back(place);
  }
  return odd;
}

/// The least perfect matching: that of each set of `odd` pairs its first member with the best one.
std::vector<Pair> ExactMatching(const Metric& metric, const std::vector<int>& odd) {
  const std::uint32_t all = (1u << odd.size()) - 1u;
  std::vector<double> least(all + std::size_t{1}, kInfinity);  // to match all within the set
  std::vector<std::uint32_t> last(least.size(), 0);            // the pair that its matching adds
  least[0] = 0.0;
  for (std::uint32_t matched = 0; matched < all; ++matched) {
    if (least[matched] == kInfinity) continue;
    const int first = std::countr_one(matched);
    for (int second = first + 1; second < static_cast<int>(odd.size()); ++second) {
      const std::uint32_t pair = 1u << first | 1u << second;
      const double length_m = least[matched] + metric.Length(odd[first], odd[second]);
      if ((matched & pair) == 0 && length_m < least[matched | pair]) {
        least[matched | pair] = length_m;
        last[matched | pair] = pair;
      }
    }
  }
  std::vector<Pair> pairs;
  for (std::uint32_t left = all; left != 0; left ^= last[left]) {
    pairs.emplace_back(odd[std::countr_zero(last[left])], odd[std::bit_width(last[left]) - 1]);
  }
  return pairs;
}

/// Exchanges partners between the two pairs if that makes them shorter.
bool Exchange(const Metric& metric, Pair& a, Pair& b) {
  const Pair straight[2] = {{a.first, b.first}, {a.second, b.second}};
  const Pair crossed[2] = {{a.first, b.second}, {a.second, b.first}};
  for (const auto& changed : {straight, crossed}) {
    const double before_m = metric.Length(a) + metric.Length(b);
    const double after_m = metric.Length(changed[0]) + metric.Length(changed[1]);
    if (after_m < before_m * (1.0 - 1e-12)) {
      a = changed[0];
      b = changed[1];
      return true;
    }
  }
  return false;
}

std::vector<Pair> GreedyMatching(const Metric& metric, std::vector<int> left) {
  std::vector<Pair> pairs;
  while (!left.empty()) {
    const int place = left.back();
    left.pop_back();
    const auto partner =
        std::ranges::min_element(left, {}, [&](int other) { return metric.Length(place, other); });
    pairs.emplace_back(place, *partner);
    left.erase(partner);
  }
  for (bool improved = true; improved;) {
    improved = false;
    for (std::size_t a = 0; a < pairs.size(); ++a) {
      for (std::size_t b = a + 1; b < pairs.size(); ++b) {
        improved = Exchange(metric, pairs[a], pairs[b]) || improved;
      }
    }
  }
  return pairs;
}

/// The places in the order in which a closed walk over each edge once first meets them.
std::vector<int> OrderOfFirstVisits(const std::vector<Pair>& edges, int count) {
  std::vector<std::vector<int>> at(static_cast<std::size_t>(count));  // edges not walked yet
  for (std::size_t e = 0; e < edges.size(); ++e) {
    at[edges[e].first].push_back(static_cast<int>(e));
    at[edges[e].second].push_back(static_cast<int>(e));
  }
  std::vector<bool> walked(edges.size(), false);
  std::vector<bool> met(static_cast<std::size_t>(count), false);
  std::vector<int> order;
  std::vector<int> way{0};
  while (!way.empty()) {
    const int place = way.back();
    if (at[place].empty()) {
      if (!met[place]) order.push_back(place);
      met[place] = true;
      way.pop_back();
      continue;
    }
    const int edge = at[place].back();
    at[place].pop_back();
    if (walked[edge]) continue;
    walked[edge] = true;
    way.push_back(edges[edge].first == place ? edges[edge].second : edges[edge].first);
  }
  return order;
}

}  // namespace

std::vector<int> ChristofidesTour(const ShortestPaths& paths, std::span<const int> vertices) {
  constexpr std::size_t kMostExact = 16;
  const Metric metric(paths, vertices);
  std::vector<Pair> edges = MinimumSpanningTree(metric);
  const std::vector<int> odd = OddPlaces(edges, metric.count());
  const std::vector<Pair> matching =
      odd.size() <= kMostExact ? ExactMatching(metric, odd) : GreedyMatching(metric, odd);
  edges.insert(edges.end(), matching.begin(), matching.end());
  std::vector<int> tour;
  for (const int place : OrderOfFirstVisits(edges, metric.count())) {
    tour.push_back(vertices[place]);
  }
  return tour;
}

}  // namespace ronda
