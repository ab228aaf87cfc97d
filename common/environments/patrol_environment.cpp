#include "common/environments/patrol_environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/base/check.h"
#include "common/base/error.h"

namespace ronda {
namespace {

constexpr double kHorizonsToSettle = 5.0;  // after 5 T_d a next visit changes a reward by < 0.7 %

void Require(bool holds, const char* name, const char* rule, double value) {
  if (!holds || !std::isfinite(value)) {
    throw InputError(fmt::format("environment.{}: must be {}, got {}", name, rule, value));
  }
}

const PatrolEnvironmentOptions& Checked(const PatrolEnvironmentOptions& options) {
  Require(options.agents >= 1, "agents", "≥ 1", options.agents);
  Require(options.closed_walk_m > 0.0, "closed_walk_m", "> 0", options.closed_walk_m);
  Require(options.horizon > 0.0, "horizon", "> 0", options.horizon);
  Require(options.episode_length > 0.0, "episode_length", "> 0", options.episode_length);
  Require(options.initial_idleness >= 0.0, "initial_idleness", "≥ 0", options.initial_idleness);
  Require(options.reward_n_worst >= 1, "reward_n_worst", "≥ 1", options.reward_n_worst);
  CheckConditions(options.conditions, options.agents);
  return options;
}

}  // namespace

ObservationOptions ObservationOf(const PatrolEnvironmentOptions& options) {
  ObservationOptions observation = options.observation;
  observation.robots = options.agents;
  observation.stay = options.conditions.stay_s > 0.0;
  return observation;
}

PatrolEnvironment::PatrolEnvironment(const PatrolGraph& graph, const ShortestPaths& paths,
                                     const PatrolEnvironmentOptions& options)
    : options_(Checked(options)),
      world_(graph, WorldOptionsOf(options.conditions, options.agents)),
      beliefs_(graph, options.agents, kObservedKnowledge, options.conditions.communication),
      encoder_(graph, paths, ObservationOf(options)),
      spec_{.observation_size = encoder_.observation_size(),
            .num_actions = encoder_.num_actions(),
            .num_agents = options.agents},
      agents_(static_cast<std::size_t>(options.agents)),
      pending_(static_cast<std::size_t>(graph.vertex_count())),
      idleness_s_(pending_.size()),
      observation_(static_cast<std::size_t>(spec_.observation_size)),
      legal_(static_cast<std::size_t>(spec_.num_actions)) {
  if (graph.edge_count() == 0) {
    throw InputError(fmt::format("map {}: patrolling needs at least 1 edge, got 0", graph.name()));
  }
  parameters_.reference_s = options.closed_walk_m / world_.total_speed_mps();
  parameters_.horizon_s = options.horizon * parameters_.reference_s;
  parameters_.n_worst = options.reward_n_worst;
  settle_within_s_ = kHorizonsToSettle * parameters_.horizon_s;
  episode_s_ = options.episode_length * parameters_.reference_s;
  settled_.reserve(2 * pending_.size() + 1);
}

void PatrolEnvironment::Reset(const Rng& rng) {
  Rng draws = rng;
  const PatrolGraph& graph = world_.graph();
  const auto starts = PatrolWorld::RandomStarts(graph, options_.agents, draws);
  std::vector<double> last_visits_s(pending_.size(), 0.0);
  if (options_.initial_idleness > 0.0) {
    const double largest_s = options_.initial_idleness * parameters_.reference_s;
    for (double& last_s : last_visits_s) last_s = -largest_s * draws.Uniform();
  }
  world_.Reset(starts, draws);
  for (int v = 0; v < graph.vertex_count(); ++v) world_.SetLastVisit(v, last_visits_s[v]);

  world_.Schedule(DrawChanges(options_.conditions.attrition, options_.agents, episode_s_,
                              SplitSeed(draws(), 0)));
  beliefs_.Begin(world_, SplitSeed(draws(), 1));

  agents_.assign(agents_.size(), Agent{});
  pending_.assign(pending_.size(), Pending{});
  settled_.clear();
  state_ = EpisodeState::kRunning;
  const auto arrival = world_.NextArrival(kNever_s);
  MakeDecision(*arrival);
}

StepOutcome PatrolEnvironment::Step(int action) {
  RONDA_CHECK(state_ == EpisodeState::kRunning, "a step after the end of the episode");
  RONDA_CHECK(action >= 0 && action < spec_.num_actions && legal_[action] == 1,
              "action {} of {} is not legal for robot {} at vertex {}", action, spec_.num_actions,
              decision_.agent, world_.target(decision_.agent));
  settled_.clear();
  const int robot = decision_.agent;
  world_.Depart(robot, encoder_.NextVertex(world_.target(robot), action));
  beliefs_.Departed(world_, robot);

  const auto arrival = world_.NextArrival(kNever_s);
  const bool last_step = arrival->time_s >= episode_s_;
  SettleLate(arrival->time_s);
  SettleArrival(*arrival, last_step);
  MakeDecision(*arrival);
  if (last_step) {
    state_ = EpisodeState::kCut;
    SettleLate(kNever_s);
  }
  return {.state = state_, .settled = settled_};
}

void PatrolEnvironment::SettleArrival(const Arrival& arrival, bool last_step) {
  const bool stayed = world_.previous_vertex(arrival.robot) == arrival.vertex;
  if (!stayed && pending_[arrival.vertex].agent >= 0) {
    SettlePending(arrival.vertex, arrival.time_s - pending_[arrival.vertex].since_s);
  }
  const Agent& agent = agents_[arrival.robot];
  if (agent.count == 0) return;                     // its start: no decision led here
  if (world_.previous_vertex(arrival.robot) < 0) {  // it joins again
    settled_.push_back({.agent = arrival.robot, .index = agent.count - 1, .reward = 0.0f});
    return;
  }
  for (std::size_t v = 0; v < idleness_s_.size(); ++v) {
    idleness_s_[v] = world_.idleness_s(static_cast<int>(v));
  }
  // The visit has reset it in the world; without the stay it would have grown.
  idleness_s_[arrival.vertex] =
      stayed ? world_.graph().weights()[arrival.vertex] * world_.stay_s() : arrival.idleness_s;
  const float reward = Reward(options_.reward,
                              {.travel_s = arrival.time_s - agent.made_s,
                               .vertex = arrival.vertex,
                               .idleness_s = idleness_s_,
                               .last_step = last_step},
                              parameters_);
  if (stayed || !WaitsForNextVisit(options_.reward)) {
    settled_.push_back({.agent = arrival.robot, .index = agent.count - 1, .reward = reward});
    return;
  }
  pending_[arrival.vertex] = {.agent = arrival.robot,
                              .index = agent.count - 1,
                              .since_s = arrival.time_s,
                              .reward = reward};
}

/// Settles the visits that waited too long at `now_s`: nobody came.
void PatrolEnvironment::SettleLate(double now_s) {
  for (std::size_t vertex = 0; vertex < pending_.size(); ++vertex) {
    if (pending_[vertex].agent >= 0 && now_s - pending_[vertex].since_s > settle_within_s_) {
      SettlePending(static_cast<int>(vertex), kNever_s);
    }
  }
}

void PatrolEnvironment::SettlePending(int vertex, double next_visit_after_s) {
  Pending& pending = pending_[vertex];
  settled_.push_back({.agent = pending.agent,
                      .index = pending.index,
                      .reward = HindsightReward(pending.reward, next_visit_after_s, parameters_)});
  pending.agent = -1;
}

void PatrolEnvironment::MakeDecision(const Arrival& arrival) {
  Agent& agent = agents_[arrival.robot];
  encoder_.Encode(beliefs_.Arrived(world_, arrival), observation_, legal_);
  decision_ = {.agent = arrival.robot,
               .index = agent.count,
               .observation = observation_,
               .legal_actions = legal_,
               .discount = agent.count == 0
                               ? 1.0f
                               : Discount(arrival.time_s - agent.made_s, parameters_.horizon_s)};
  ++agent.count;
  agent.made_s = arrival.time_s;
}

}  // namespace ronda
