#include "deploy/run_state.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "common/base/error.h"
#include "tests/temporary_folder.h"

namespace ronda {
namespace {

TEST_CASE("A run's state reads back as it was written") {
  const TemporaryFolder folder;
  RunState state;
  state.totals.sent = 7;
  state.totals.weights_version = 12;
  state.training_s = 33.5;
  state.updates = 99;
  state.restarts = {{"actor", 2}};
  state.best = BestPolicy{.agi_s = 12.5, .second_half = true};

  WriteRunState(folder.path(), state);
  const RunState sut = ReadRunState(folder.path());

  CHECK(sut.totals.sent == 7);
  CHECK(sut.totals.weights_version == 12);
  CHECK(sut.training_s == 33.5);
  CHECK(sut.updates == 99);
  CHECK(sut.restarts.at("actor") == 2);
  REQUIRE(sut.best.has_value());
  CHECK(sut.best->agi_s == 12.5);
  CHECK(sut.best->second_half);
}

TEST_CASE("A folder without state is a new run, a file that is no state is refused by name") {
  const TemporaryFolder folder;
  CHECK(ReadRunState(folder.path()).totals.sent == 0);

  std::ofstream(folder / "state.json") << "{\"totals\": 3}";
  CHECK_THROWS_AS(ReadRunState(folder.path()), CheckpointError);
  CHECK_THROWS_WITH(ReadRunState(folder.path()), Catch::Contains("state.json"));
}

TEST_CASE("Progress is the larger share of the two budgets, and 0 where there is none") {
  RunConfig run;
  CHECK(Progress(run, 100.0, 100) == 0.0);
  run.budget_s = 50.0;
  CHECK(Progress(run, 25.0, 1'000'000) == 0.5);
  run.budget_decisions = 2'000'000;
  CHECK(Progress(run, 5.0, 1'000'000) == 0.5);
  CHECK(Progress(run, 40.0, 1'000'000) == 0.8);
}

}  // namespace
}  // namespace ronda
