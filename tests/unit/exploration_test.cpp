#include "actor/exploration.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "common/base/error.h"

namespace ronda {
namespace {

TEST_CASE("Linear exploration falls evenly to its end and stays there") {
  const ExplorationOptions options{.start = 1.0, .end = 0.05, .share = 0.3};
  CHECK(ScheduledEpsilon(options, 0.0) == 1.0);
  CHECK(ScheduledEpsilon(options, 0.15) == Approx(0.525));
  CHECK(ScheduledEpsilon(options, 0.3) == Approx(0.05));
  CHECK(ScheduledEpsilon(options, 1.0) == Approx(0.05));
  CHECK(ScheduledEpsilon(options, 7.0) == Approx(0.05));
}

TEST_CASE("Exponential exploration falls by equal factors and stays at its end") {
  const ExplorationOptions options{
      .decay = ExplorationDecay::kExponential, .start = 1.0, .end = 0.01, .share = 0.5};
  CHECK(ScheduledEpsilon(options, 0.0) == Approx(1.0));
  CHECK(ScheduledEpsilon(options, 0.25) == Approx(0.1));
  CHECK(ScheduledEpsilon(options, 0.5) == Approx(0.01));
  CHECK(ScheduledEpsilon(options, 0.9) == Approx(0.01));
}

TEST_CASE("A ladder gives the first actor the schedule's value and the last its power 1 + alpha") {
  const ExplorationOptions options{.start = 0.4, .end = 0.4, .ladder = 3.0};
  CHECK(Epsilon(options, 0.5, 0, 4) == Approx(0.4));
  CHECK(Epsilon(options, 0.5, 1, 4) == Approx(std::pow(0.4, 2.0)));
  CHECK(Epsilon(options, 0.5, 3, 4) == Approx(std::pow(0.4, 4.0)));
  CHECK(Epsilon(options, 0.5, 0, 1) == Approx(0.4));
}

TEST_CASE("Exploration out of range is refused with key, rule and value") {
  CHECK_THROWS_WITH(CheckExploration({.start = 1.5}),
                    "exploration.start: must be in 0 … 1, got 1.5");
  CHECK_THROWS_WITH(CheckExploration({.share = 0.0}),
                    "exploration.share: must be > 0 and ≤ 1, got 0");
  CHECK_THROWS_WITH(CheckExploration({.ladder = -1.0}), "exploration.ladder: must be ≥ 0, got -1");
  CHECK_THROWS_AS(CheckExploration({.decay = ExplorationDecay::kExponential, .end = 0.0}),
                  InputError);
  CHECK_NOTHROW(CheckExploration({.end = 0.0}));
  CHECK_THROWS_WITH(ParseExplorationDecay("cosine"), Catch::Contains("linear, exponential"));
}

}  // namespace
}  // namespace ronda
