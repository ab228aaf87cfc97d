#include "replay/rate_limiter.h"

#include <catch2/catch.hpp>

#include "common/base/error.h"
#include "common/base/rng.h"

namespace ronda {
namespace {

TEST_CASE("Nothing is sampled before the minimum fill, and inserting stops at the error buffer") {
  RateLimiter sut({.min_size = 100, .samples_per_insert = 4.0, .error_buffer = 200.0}, 32);

  CHECK(sut.InsertRoom() == 150);
  sut.Inserted(99);
  CHECK_FALSE(sut.CanSample(32, 99));
  sut.Inserted(51);
  CHECK(sut.InsertRoom() == 0);
  CHECK(sut.CanSample(32, 150));
  sut.Sampled(40);
  CHECK(sut.InsertRoom() == 10);
}

TEST_CASE("Sampling stops when it has run ahead of inserting by the error buffer") {
  RateLimiter sut({.min_size = 10, .samples_per_insert = 2.0, .error_buffer = 40.0}, 8);
  sut.Inserted(10);

  int batches = 0;
  while (sut.CanSample(8, 10)) {
    sut.Sampled(8);
    ++batches;
  }

  CHECK(batches == 5);
}

TEST_CASE("Both sides never wait at once, whatever order they come in") {
  RateLimiter sut({.min_size = 50, .samples_per_insert = 8.0, .error_buffer = 100.0}, 64);
  Rng rng(3);
  for (int i = 0; i < 100'000; ++i) {
    const bool can_sample = sut.CanSample(64, sut.inserted());
    const bool can_insert = sut.InsertRoom() > 0;
    REQUIRE((can_sample || can_insert));
    if (can_sample && (!can_insert || rng.Below(2) == 0)) {
      sut.Sampled(64);
    } else {
      sut.Inserted(1);
    }
  }
  const double ratio = static_cast<double>(sut.sampled()) / static_cast<double>(sut.inserted());
  CHECK(ratio == Approx(8.0).epsilon(0.02));
}

TEST_CASE("An error buffer that would let both sides wait is refused with a sentence") {
  const RateLimiterConfig config{.min_size = 10, .samples_per_insert = 8.0, .error_buffer = 100.0};

  CHECK_THROWS_WITH(RateLimiter(config, 128), Catch::Contains("replay.error_buffer") &&
                                                  Catch::Contains("136") && Catch::Contains("100"));
}

}  // namespace
}  // namespace ronda
