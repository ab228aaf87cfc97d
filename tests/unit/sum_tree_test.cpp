#include "replay/sum_tree.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "common/base/rng.h"

namespace ronda {
namespace {

TEST_CASE(
    "Find returns the index whose interval holds the position, for capacities that are no power of "
    "two") {
  SumTree sut(5);
  const std::vector<double> weights{1.0, 0.0, 2.0, 0.0, 4.0};
  for (std::size_t i = 0; i < weights.size(); ++i) sut.Set(i, weights[i]);

  CHECK(sut.total() == 7.0);
  CHECK(sut.Find(0.0) == 0);
  CHECK(sut.Find(0.999) == 0);
  CHECK(sut.Find(1.0) == 2);
  CHECK(sut.Find(2.999) == 2);
  CHECK(sut.Find(3.0) == 4);
  CHECK(sut.Find(6.999) == 4);
}

TEST_CASE("A position at or beyond the total still names an index of positive weight") {
  SumTree sut(3);
  sut.Set(0, 1.0);
  sut.Set(1, 2.0);

  CHECK(sut.Find(3.0) == 1);
  CHECK(sut.Find(100.0) == 1);
}

TEST_CASE("A million updates leave the total equal to the sum of the weights") {
  SumTree sut(1000);
  std::vector<double> weights(1000, 0.0);
  Rng rng(7);
  for (int i = 0; i < 1'000'000; ++i) {
    const auto index = rng.Below(1000);
    weights[index] = std::pow(10.0, 12.0 * rng.Uniform() - 6.0);
    sut.Set(index, weights[index]);
  }

  double expected = 0.0;
  for (const double weight : weights) expected += weight;
  CHECK(sut.total() == Approx(expected).epsilon(1e-12));
}

}  // namespace
}  // namespace ronda
