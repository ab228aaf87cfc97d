#include "common/evaluation/statistics.h"

#include <catch2/catch.hpp>
#include <vector>

namespace ronda {
namespace {

TEST_CASE("Mean and half width are those of a t table") {
  // Standard deviation 1.290994, over √4, times t(3; 0.975) = 3.182446.
  const Estimate sut = MeanWithInterval(std::vector<double>{1.0, 2.0, 3.0, 4.0});

  CHECK(sut.mean == 2.5);
  REQUIRE(sut.ci95);
  CHECK(*sut.ci95 == Approx(2.054260).epsilon(1e-6));
}

TEST_CASE("One value has no interval") {
  const Estimate sut = MeanWithInterval(std::vector<double>{7.0});

  CHECK(sut.mean == 7.0);
  CHECK_FALSE(sut.ci95);
}

TEST_CASE("Mean and interval are divided by what is known exactly") {
  const Estimate sut = Over({.mean = 6.0, .ci95 = 3.0}, 2.0);
  CHECK(sut.mean == 3.0);
  CHECK(sut.ci95 == 1.5);
  CHECK_FALSE(Over({.mean = 6.0, .ci95 = std::nullopt}, 2.0).ci95);
}

TEST_CASE("What pairs share cancels in their ratio") {
  const std::vector<double> denominators{1.0, 5.0, 2.0, 8.0};
  const std::vector<double> numerators{3.0, 15.0, 6.0, 24.0};

  const Estimate sut = PairedRatio(numerators, denominators);

  CHECK(sut.mean == Approx(3.0));
  REQUIRE(sut.ci95);
  CHECK(*sut.ci95 == Approx(0.0).margin(1e-12));
}

TEST_CASE("A ratio's interval is that of the linearised ratio") {
  // R = 2; residuals (2 − 2·1, 4 − 2·2, 9 − 2·3, 5 − 2·4) / 2.5 = 0, 0, 1.2, −1.2:
  // standard deviation 0.979796, over √4, times 3.182446.
  const Estimate sut =
      PairedRatio(std::vector<double>{2.0, 4.0, 9.0, 5.0}, std::vector<double>{1.0, 2.0, 3.0, 4.0});

  CHECK(sut.mean == Approx(2.0));
  REQUIRE(sut.ci95);
  CHECK(*sut.ci95 == Approx(1.559074).epsilon(1e-6));
}

}  // namespace
}  // namespace ronda
