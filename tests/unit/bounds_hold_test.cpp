// What is measured against what is proved: every strategy on every shipped map, episode by episode.
//
// The bounds hold for unlimited time. A window of T seconds may lie below them by a share of at
// most 2 (N l_max + Σ_v l_v) / (S T), S the sum of speeds, l_max the longest edge, l_v the shortest
// at v; docs/bounds.md derives it. So nothing here depends on luck.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "common/evaluation/protocol.h"
#include "common/evaluation/report.h"
#include "tests/unit/evaluation_map.h"

namespace ronda {
namespace {

double LargestShortfall(const PatrolGraph& graph, const EvaluationOptions& options,
                        double window_s) {
  double longest_m = 0.0;
  for (const Edge& edge : graph.edges()) longest_m = std::max(longest_m, edge.length_m);
  double length_m = options.agents * longest_m;
  for (int v = 0; v < graph.vertex_count(); ++v) {
    const auto lengths_m = graph.lengths_m(v);
    length_m += *std::min_element(lengths_m.begin(), lengths_m.end());
  }
  return 2.0 * length_m / (TotalSpeed_mps(options.conditions, options.agents) * window_s);
}

void CheckBoundsHold(const testing::EvaluationMap& map, const std::string& strategy,
                     const EvaluationOptions& options) {
  const auto bounds = BoundsOf(map.context(), options);
  REQUIRE(bounds);
  const auto result = Evaluate(
      map.context(), [&] { return MakeStrategy(strategy, map.context()); }, options, nullptr);
  REQUIRE(result);
  const double share = 1.0 - LargestShortfall(map.graph, options, result->window_s);
  CAPTURE(map.graph.name(), strategy, options.agents, share);
  REQUIRE(share > 0.75);
  for (const EpisodeResult& episode : result->episodes) {
    CHECK(episode.agi_s >= bounds->agi_s * share);
    CHECK(episode.wi_s >= bounds->wi_s * share);
  }
}

TEST_CASE("No strategy on any shipped map does better than the bounds, with 1 to 12 robots") {
  const std::string name = GENERATE("4nodes", "cumberland", "grid", "milwaukee");
  const testing::EvaluationMap map(name);
  for (int agents = 1; agents <= 12; ++agents) {
    for (const std::string& strategy : AllStrategyNames()) {
      CheckBoundsHold(map, strategy, {.episodes = 2, .agents = agents});
    }
  }
}

TEST_CASE("Nor with priorities, robots of several speeds, and one that fails") {
  testing::EvaluationMap map("milwaukee");
  Conditions conditions;
  conditions.speeds_mps = {1.0, 0.25, 2.0};
  conditions.priorities = {{"3", 9.0}, {"7", 0.1}, {"20", 30.0}};
  conditions.attrition.changes = {{.time_s = 40000.0, .robot = 1}};
  map.graph = WithPriorities(map.graph, conditions);
  for (const std::string& strategy : AllStrategyNames()) {
    CheckBoundsHold(map, strategy, {.episodes = 2, .agents = 6, .conditions = conditions});
  }
}

/// Each robot goes to and fro on one edge.
class Shuttle : public Strategy {
 public:
  explicit Shuttle(std::vector<std::pair<int, int>> edges) : edges_(std::move(edges)) {}

  std::vector<RobotStart> Begin(const PatrolGraph&, std::span<const double>, Rng&) override {
    std::vector<RobotStart> starts;
    for (const auto& [from, to] : edges_) starts.push_back({.vertex = from, .next = from});
    return starts;
  }
  Knowledge knowledge() const override { return {}; }
  int Decide(const Belief& belief, Rng&) override {
    const auto& [from, to] = edges_[belief.robot];
    return belief.vertex == from ? to : from;
  }

 private:
  std::vector<std::pair<int, int>> edges_;
};

TEST_CASE(
    "4nodes, 2 robots: each shuttles on an edge of 25 m, which is the optimum of AGI and WI") {
  const testing::EvaluationMap map("4nodes");
  std::vector<std::pair<int, int>> edges;
  for (const Edge& edge : map.graph.edges()) {
    if (edge.length_m == 25.0) edges.emplace_back(edge.source, edge.target);
  }
  REQUIRE(edges.size() == 2);
  const EvaluationOptions options{.episodes = 1, .agents = 2};

  const auto bounds = BoundsOf(map.context(), options);
  const auto result = Evaluate(
      map.context(), [&] { return std::make_unique<Shuttle>(edges); }, options, nullptr);

  CHECK(result->agi_s()[0] == Approx(25.0));
  CHECK(result->wi_s()[0] == Approx(50.0));
  CHECK(bounds->agi_s == Approx(25.0).epsilon(1e-6));
  CHECK(bounds->wi_s == Approx(50.0).epsilon(1e-6));
}

TEST_CASE("Grid: robots evenly spaced on the closed walk are at the bound on WI") {
  const testing::EvaluationMap map("grid");
  for (const int agents : {1, 4, 12}) {
    EvaluationOptions options{.episodes = 1, .agents = agents};
    options.conditions.speeds_mps = {map.graph.metres_per_px()};  // 1 px/s

    const auto bounds = BoundsOf(map.context(), options);
    const auto result = Evaluate(
        map.context(), [&] { return MakeStrategy("cyclic", map.context()); }, options, nullptr);

    CHECK(bounds->wi_s == Approx(1976.0 / agents).epsilon(1e-6));
    CHECK(result->wi_s()[0] == Approx(bounds->wi_s).epsilon(1e-6));
  }
}

TEST_CASE("Where robots may stay the bounds let them, and where they are repaired there are none") {
  const testing::EvaluationMap map("4nodes");
  EvaluationOptions options{.agents = 3};
  const double moving_s = BoundsOf(map.context(), options)->agi_s;

  options.conditions.stay_s = 5.0;
  CHECK(BoundsOf(map.context(), options)->agi_s == Approx(12.5).epsilon(1e-5));
  CHECK(moving_s == Approx(50.0 / 3.0).epsilon(1e-5));

  options.conditions.attrition.mean_time_to_failure_s = 100.0;
  CHECK(BoundsOf(map.context(), options));
  options.conditions.attrition.repair_s = 10.0;
  CHECK_FALSE(BoundsOf(map.context(), options));
}

}  // namespace
}  // namespace ronda
