#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "common/world/christofides.h"
#include "tests/unit/graph/graphs.h"

namespace ronda {
namespace {

using testing::RandomGraphData;

double LengthOf(const ShortestPaths& paths, const std::vector<int>& tour) {
  double length_m = 0.0;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    length_m += paths.distance_m(tour[i], tour[(i + 1) % tour.size()]);
  }
  return length_m;
}

double ShortestTour(const ShortestPaths& paths, std::vector<int> vertices) {
  std::sort(vertices.begin() + 1, vertices.end());
  double least_m = LengthOf(paths, vertices);
  while (std::next_permutation(vertices.begin() + 1, vertices.end())) {
    least_m = std::min(least_m, LengthOf(paths, vertices));
  }
  return least_m;
}

TEST_CASE("A tour of Christofides is at most 1.5 times as long as the shortest") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const PatrolGraph graph(RandomGraphData(12, 8, seed));
    const ShortestPaths paths(graph);
    std::vector<int> cell(8);
    std::iota(cell.begin(), cell.end(), 2);

    const std::vector<int> tour = ChristofidesTour(paths, cell);

    CHECK(tour.front() == 2);
    CHECK(std::ranges::is_permutation(tour, cell));
    CHECK(LengthOf(paths, tour) <= 1.5 * ShortestTour(paths, cell) + 1e-9);
  }
}

TEST_CASE("A tour of many vertices, whose matching is not exact, has each of them once") {
  const PatrolGraph graph(RandomGraphData(200, 60, 3));
  const ShortestPaths paths(graph);
  std::vector<int> all(200);
  std::iota(all.begin(), all.end(), 0);

  const std::vector<int> tour = ChristofidesTour(paths, all);

  CHECK(std::ranges::is_permutation(tour, all));
}

TEST_CASE("Tours of one and of two vertices") {
  const PatrolGraph graph(RandomGraphData(200, 60, 3));
  const ShortestPaths paths(graph);
  CHECK(ChristofidesTour(paths, std::vector<int>{7}) == std::vector<int>{7});
  CHECK(ChristofidesTour(paths, std::vector<int>{7, 3}) == std::vector<int>{7, 3});
}

}  // namespace
}  // namespace ronda
