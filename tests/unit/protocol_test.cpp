#include "common/evaluation/protocol.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <limits>
#include <map>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "tests/temporary_folder.h"
#include "tests/unit/evaluation_map.h"

namespace ronda {
namespace {

using testing::EvaluationMap;

EvaluationResult Play(const EvaluationMap& map, const std::string& strategy,
                      const EvaluationOptions& options, TraceWriter* trace = nullptr) {
  const auto make = [&] { return MakeStrategy(strategy, map.context()); };
  const auto result = Evaluate(map.context(), make, options, trace);
  REQUIRE(result);
  return *result;
}

TEST_CASE("Steady: T_ref is the closed walk over the sum of speeds, 20 of it warm up, 60 count") {
  const EvaluationMap map("4nodes");

  const auto result =
      Play(map, "sebs", {.episodes = 1, .agents = 2, .conditions = {.speeds_mps = {0.5}}});

  CHECK(result.t_ref_s == Approx(130.0));
  CHECK(result.warmup_s == Approx(2600.0));
  CHECK(result.window_s == Approx(7800.0));
}

TEST_CASE("Thesis: no warm-up, the horizon is the window, final idleness is that of its end") {
  // One robot at 25 m/s on the walk 0 2 3 1 of 25, 40, 25 and 40 m: the horizon ends as its fifth
  // lap does, when 0 has just been reached and 2, 3 and 1 were left 105, 65 and 40 m ago.
  const EvaluationMap map("4nodes");

  const auto result = Play(map, "cyclic",
                           {.protocol = Protocol::kThesis,
                            .horizon_s = 26.0 + 1e-6,
                            .episodes = 1,
                            .agents = 1,
                            .conditions = {.speeds_mps = {25.0}}});

  CHECK(result.warmup_s == 0.0);
  CHECK(result.window_s == 26.0 + 1e-6);
  CHECK(result.final_s()[0] == Approx((0.0 + 105.0 + 65.0 + 40.0) / 25.0 / 4.0).epsilon(1e-5));
  CHECK(result.wi_s()[0] == Approx(5.2).epsilon(1e-6));
}

TEST_CASE("Results do not depend on the number of threads") {
  const EvaluationMap map("grid");
  for (const char* strategy : {"random", "cr"}) {
    const EvaluationOptions options{
        .episodes = 7, .seed = 3, .agents = 3, .conditions = {.travel_noise = 0.1}, .threads = 1};
    auto many = options;
    many.threads = 4;

    const auto alone = Play(map, strategy, options);
    const auto together = Play(map, strategy, many);

    CHECK(alone.agi_s() == together.agi_s());
    CHECK(alone.wi_s() == together.wi_s());
    CHECK(alone.final_s() == together.final_s());
    CHECK(alone.decisions() == together.decisions());
  }
}

TEST_CASE("Episodes differ, seeds differ, and the same seed gives the same results") {
  const EvaluationMap map("grid");
  const EvaluationOptions options{.episodes = 3, .seed = 3, .agents = 3};
  auto other = options;
  other.seed = 4;

  const auto agi_s = Play(map, "random", options).agi_s();

  CHECK(agi_s[0] != agi_s[1]);
  CHECK(agi_s != Play(map, "random", other).agi_s());
  CHECK(agi_s == Play(map, "random", options).agi_s());
}

struct TraceRow {
  int episode;
  double time_s;
  int robot;
  std::string vertex;
  std::string event;
};

struct TraceFile {
  std::string first_line;
  std::string header;
  std::vector<TraceRow> rows;
};

TraceFile ReadTrace(const std::filesystem::path& path) {
  std::ifstream file(path);
  TraceFile trace;
  std::getline(file, trace.first_line);
  std::getline(file, trace.header);
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::array<std::string, 5> field;
    for (auto& text : field) std::getline(fields, text, ',');
    trace.rows.push_back(
        {std::stoi(field[0]), std::stod(field[1]), std::stoi(field[2]), field[3], field[4]});
  }
  return trace;
}

struct Recomputed {
  double agi_s = 0.0;
  double wi_s = 0.0;
  double final_s = 0.0;
};

/// AGI, WI and final idleness of one episode from its visits alone, interval by interval.
Recomputed Recompute(const TraceFile& trace, int episode, double warmup_s,
                     const PatrolGraph& graph) {
  std::map<std::string, std::vector<double>> visits_s;
  for (int v = 0; v < graph.vertex_count(); ++v) visits_s[graph.vertex_id(v)] = {0.0};
  double end_s = 0.0;
  for (const TraceRow& row : trace.rows) {
    if (row.episode != episode) continue;
    if (row.event == "end") {
      end_s = row.time_s;
    } else if (row.event != "fail") {
      visits_s.at(row.vertex).push_back(row.time_s);
    }
  }
  Recomputed result;
  double integral_s2 = 0.0;
  for (auto& [id, times_s] : visits_s) {
    result.final_s += (end_s - times_s.back()) / graph.vertex_count();
    times_s.push_back(end_s);
    for (std::size_t i = 1; i < times_s.size(); ++i) {
      if (times_s[i] <= warmup_s) continue;
      const double from_s = std::max(0.0, warmup_s - times_s[i - 1]);
      const double to_s = times_s[i] - times_s[i - 1];
      integral_s2 += 0.5 * (to_s * to_s - from_s * from_s);
      result.wi_s = std::max(result.wi_s, to_s);
    }
  }
  result.agi_s = integral_s2 / ((end_s - warmup_s) * graph.vertex_count());
  return result;
}

TEST_CASE("AGI, WI and final idleness recomputed from the trace are those reported") {
  const EvaluationMap map("cumberland");
  const TemporaryFolder folder;
  for (const char* strategy : {"cr", "cyclic"}) {
    CAPTURE(strategy);
    const auto path = folder.path() / (std::string(strategy) + ".csv");
    TraceWriter sut(path, map.graph, "cumberland");
    const auto result = Play(
        map, strategy, {.episodes = 2, .agents = 7, .conditions = {.travel_noise = 0.05}}, &sut);
    CHECK_FALSE(std::filesystem::exists(path));
    sut.Commit();

    const TraceFile trace = ReadTrace(path);
    CHECK(trace.first_line.starts_with("# warmup_s="));
    CHECK(trace.first_line.ends_with(" map=cumberland"));
    CHECK(trace.header == "episode,time_s,robot,vertex,event");
    for (int episode = 0; episode < 2; ++episode) {
      const auto again = Recompute(trace, episode, result.warmup_s, map.graph);
      CHECK(again.agi_s == Approx(result.agi_s()[episode]).epsilon(1e-6));
      CHECK(again.wi_s == Approx(result.wi_s()[episode]).epsilon(1e-6));
      CHECK(again.final_s == Approx(result.final_s()[episode]).epsilon(1e-6));
    }
    const auto count = [&](const std::string& event) {
      return std::count_if(trace.rows.begin(), trace.rows.end(),
                           [&](const TraceRow& row) { return row.event == event; });
    };
    CHECK(count("start") == 14);
    CHECK(count("end") == 2);
    CHECK(trace.rows.back().robot == -1);
    CHECK(trace.rows.back().vertex == "-1");
    CHECK(trace.rows.back().time_s ==
          Approx(result.warmup_s + result.window_s).epsilon(0).margin(1e-8));
  }
}

/// All that makes patrolling hard, at once.
Conditions HardConditions() {
  Conditions conditions{.speeds_mps = {1.0, 0.6}, .travel_noise = 0.2};
  conditions.communication = {.message_loss = 0.3,
                              .message_range_m = 40.0,
                              .message_delay_s = 3.0,
                              .observation_radius_m = 12.0};
  conditions.attrition = {.mean_time_to_failure_s = 400.0, .repair_s = 100.0};
  return conditions;
}

TEST_CASE("Under every condition the trace tells what was measured, with failures and joinings") {
  const EvaluationMap map("cumberland");
  const TemporaryFolder folder;
  TraceWriter sut(folder.path() / "trace", map.graph, "cumberland");
  const auto result =
      Play(map, "er", {.episodes = 2, .agents = 6, .conditions = HardConditions()}, &sut);
  sut.Commit();

  const TraceFile trace = ReadTrace(folder.path() / "trace");
  std::map<std::pair<int, int>, bool> there;
  int failures = 0;
  for (const TraceRow& row : trace.rows) {
    if (row.event == "end") continue;
    bool& is_there = there[{row.episode, row.robot}];
    if (row.event == "fail") {
      REQUIRE(is_there);
      CHECK(row.vertex == "-1");
      ++failures;
    } else if (row.event != "visit") {
      REQUIRE_FALSE(is_there);
    } else {
      REQUIRE(is_there);
    }
    is_there = row.event != "fail";
  }
  CHECK(failures > 20);
  for (int episode = 0; episode < 2; ++episode) {
    const auto again = Recompute(trace, episode, result.warmup_s, map.graph);
    CHECK(again.agi_s == Approx(result.agi_s()[episode]).epsilon(1e-6));
    CHECK(again.wi_s == Approx(result.wi_s()[episode]).epsilon(1e-6));
    CHECK(again.final_s == Approx(result.final_s()[episode]).epsilon(1e-6));
  }
}

TEST_CASE("Under every condition the results do not depend on the number of threads") {
  const EvaluationMap map("cumberland");
  EvaluationOptions options{
      .episodes = 6, .agents = 6, .conditions = HardConditions(), .threads = 1};
  const auto alone = Play(map, "sebs", options);
  options.threads = 3;

  CHECK(Play(map, "sebs", options).agi_s() == alone.agi_s());
}

TEST_CASE("What robots do not hear costs what hearing is worth: sebs, 40 paired episodes") {
  // 95 % intervals of the paired ratio to complete communication, far from 1 and from each other.
  const EvaluationMap map("cumberland");
  const auto agi_s = [&](const Communication& communication) {
    return Play(map, "sebs",
                {.episodes = 40, .agents = 10, .conditions = {.communication = communication}})
        .agi_s();
  };
  const auto complete_s = agi_s({});
  const Estimate half = PairedRatio(agi_s({.message_loss = 0.5}), complete_s);
  const Estimate silent = PairedRatio(agi_s({.message_loss = 1.0}), complete_s);

  CHECK(half.mean - *half.ci95 > 1.02);
  CHECK(silent.mean - *silent.ci95 > half.mean + *half.ci95);
}

/// Goes to the first neighbour, and keeps where the robots of each episode started.
class StartsProbe final : public Strategy {
 public:
  std::vector<RobotStart> Begin(const PatrolGraph& graph, std::span<const double> speeds_mps,
                                Rng& rng) override {
    auto starts = Strategy::Begin(graph, speeds_mps, rng);
    for (const RobotStart& start : starts) vertices_.push_back(start.vertex);
    return starts;
  }
  Knowledge knowledge() const override { return {}; }
  int Decide(const Belief& belief, Rng& /*rng*/) override {
    return belief.graph->neighbours(belief.vertex)[0];
  }
  static std::vector<int> vertices_;  // one test uses it, on one thread
};
std::vector<int> StartsProbe::vertices_;

TEST_CASE("Every strategy sees the same starts in the same episode") {
  const EvaluationMap map("cumberland");
  const TemporaryFolder folder;
  const EvaluationOptions options{.episodes = 3, .seed = 5, .agents = 4, .threads = 1};
  StartsProbe::vertices_.clear();
  REQUIRE(Evaluate(
      map.context(), [] { return std::make_unique<StartsProbe>(); }, options, nullptr));

  for (const char* strategy : {"random", "er"}) {
    TraceWriter trace(folder.path() / strategy, map.graph, "cumberland");
    Play(map, strategy, options, &trace);
    trace.Commit();
    std::vector<int> vertices;
    for (const TraceRow& row : ReadTrace(folder.path() / strategy).rows) {
      if (row.event == "start") vertices.push_back(std::stoi(row.vertex));
    }
    CHECK(vertices == StartsProbe::vertices_);
  }
}

class ThrowingStrategy final : public Strategy {
 public:
  Knowledge knowledge() const override { return {}; }
  int Decide(const Belief& /*belief*/, Rng& /*rng*/) override {
    throw std::runtime_error("no decision");
  }
};

TEST_CASE("What a strategy throws on any thread reaches the caller") {
  const EvaluationMap map("4nodes");
  const auto make = [] { return std::make_unique<ThrowingStrategy>(); };

  CHECK_THROWS_WITH(Evaluate(map.context(), make, {.agents = 2, .threads = 3}, nullptr),
                    "no decision");
}

TEST_CASE("A requested stop ends the evaluation without a result") {
  const EvaluationMap map("4nodes");
  std::stop_source stop;
  stop.request_stop();
  const auto make = [&] { return MakeStrategy("random", map.context()); };

  CHECK_FALSE(Evaluate(map.context(), make, {.agents = 2}, nullptr, stop.get_token()));
}

/// What EvaluateAll gives for these, by their place.
std::vector<EvaluationResult> PlayTogether(const std::vector<Evaluation>& evaluations,
                                           int threads) {
  std::vector<EvaluationResult> results(evaluations.size());
  std::int64_t decisions = 0;
  const EvaluationListener listener{
      .on_episode = [&](std::size_t, const EpisodeResult& e) { decisions += e.decisions; },
      .on_result = [&](std::size_t i, EvaluationResult result) { results[i] = std::move(result); }};
  CHECK(EvaluateAll(evaluations, threads, listener));
  for (const EvaluationResult& result : results) decisions -= result.decisions();
  CHECK(decisions == 0);  // each episode was told of, once
  return results;
}

TEST_CASE("Evaluations over one queue give what each gives alone, in any order, on any threads") {
  const EvaluationMap grid("grid");
  const EvaluationMap nodes("4nodes");
  std::vector<Evaluation> evaluations;
  for (const EvaluationMap* map : {&grid, &nodes}) {
    for (const int agents : {1, 3}) {
      evaluations.push_back(
          {.context = map->context(),
           .make_strategy = [map] { return MakeStrategy("random", map->context()); },
           .options = {.episodes = agents + 1,
                       .seed = 3,
                       .agents = agents,
                       .conditions = {.travel_noise = 0.1}}});
    }
  }

  const auto together = PlayTogether(evaluations, 3);
  std::reverse(evaluations.begin(), evaluations.end());
  auto reversed = PlayTogether(evaluations, 1);
  std::reverse(evaluations.begin(), evaluations.end());
  std::reverse(reversed.begin(), reversed.end());

  for (std::size_t i = 0; i < evaluations.size(); ++i) {
    const Evaluation& each = evaluations[i];
    const auto alone = Evaluate(each.context, each.make_strategy, each.options, nullptr);
    REQUIRE(alone);
    CHECK(together[i].agi_s() == alone->agi_s());
    CHECK(together[i].wi_s() == alone->wi_s());
    CHECK(together[i].window_s == alone->window_s);
    CHECK(reversed[i].agi_s() == alone->agi_s());
  }
}

TEST_CASE("What is finished when a stop comes is reported whole, and nothing else") {
  const EvaluationMap map("4nodes");
  const Evaluation evaluation{.context = map.context(),
                              .make_strategy = [&] { return MakeStrategy("cr", map.context()); },
                              .options = {.episodes = 3, .agents = 2}};
  std::stop_source stop;
  std::vector<std::size_t> reported;
  const EvaluationListener listener{.on_episode = nullptr,
                                    .on_result = [&](std::size_t i, const EvaluationResult& whole) {
                                      CHECK(whole.episodes.size() == 3);
                                      reported.push_back(i);
                                      stop.request_stop();
                                    }};

  CHECK_FALSE(
      EvaluateAll(std::vector{evaluation, evaluation, evaluation}, 1, listener, stop.get_token()));
  CHECK(reported == std::vector<std::size_t>{0});
}

TEST_CASE("What the listener throws ends all evaluations and reaches the caller") {
  const EvaluationMap map("4nodes");
  const Evaluation evaluation{.context = map.context(),
                              .make_strategy = [&] { return MakeStrategy("cr", map.context()); },
                              .options = {.episodes = 2, .agents = 2}};
  const EvaluationListener listener{
      .on_episode = nullptr,
      .on_result = [](std::size_t, const EvaluationResult&) { throw std::runtime_error("full"); }};

  CHECK_THROWS_WITH(EvaluateAll(std::vector{evaluation, evaluation}, 2, listener), "full");
}

TEST_CASE("Options out of range are refused by name and value") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  CHECK_NOTHROW(CheckOptions({}));
  CHECK_THROWS_WITH(CheckOptions({.agents = 0}), "agents must be in 1 … 10000, got 0");
  CHECK_THROWS_AS(CheckOptions({.agents = 10'001}), UsageError);
  CHECK_THROWS_WITH(CheckOptions({.episodes = 0}), Catch::Contains("episodes"));
  CHECK_THROWS_WITH(CheckOptions({.conditions = {.speeds_mps = {0.0}}}), Catch::Contains("speed"));
  CHECK_THROWS_WITH(CheckOptions({.conditions = {.speeds_mps = {kNan}}}), Catch::Contains("speed"));
  CHECK_THROWS_WITH(CheckOptions({.conditions = {.travel_noise = -0.1}}), Catch::Contains("noise"));
  CHECK_THROWS_WITH(CheckOptions({.horizon_s = 0.0}), Catch::Contains("horizon"));
}

}  // namespace
}  // namespace ronda
