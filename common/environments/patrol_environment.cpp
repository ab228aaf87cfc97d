#include "common/environments/patrol_environment.h"

#include <cmath>
#include <limits>

#include "common/base/check.h"

namespace ronda {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kLatestHorizons = 5.0;  // a visit settles after so many T_d at the latest

}  // namespace

PatrolEnvironment::PatrolEnvironment(const PatrolGraph& graph, const ShortestPaths& paths,
                                     const PatrolEnvironmentConfig& config)
    : encoder_(config.observation, graph, paths),
      config_(config),
      world_(graph, {.speeds_mps = std::vector<double>(static_cast<std::size_t>(config.agents),
                                                       config.speed_mps),
                     .travel_noise = config.travel_noise}),
      reference_s_(config.closed_walk_m / world_.total_speed_mps()),
      horizon_s_(config.horizon_t_ref * reference_s_),
      phi_(static_cast<std::size_t>(config.agents)),
      open_visits_(static_cast<std::size_t>(graph.vertex_count())),
      observation_(encoder_.shape().observation_size),
      legal_(encoder_.shape().num_actions) {
  RONDA_CHECK(reference_s_ > 0.0 && horizon_s_ > 0.0, "T_ref {} s, T_d {} s", reference_s_,
              horizon_s_);
  spec_ = {.observation_size = static_cast<int>(encoder_.shape().observation_size),
           .num_actions = static_cast<int>(encoder_.shape().num_actions),
           .num_agents = config.agents};
}

void PatrolEnvironment::Reset(const Rng& rng) {
  Rng starts_rng = rng;
  const auto starts = PatrolWorld::RandomStarts(world_.graph(), config_.agents, starts_rng);
  world_.Reset(starts, SplitSeed(starts_rng(), 1));
  phi_.assign(phi_.size(), {});
  open_visits_.assign(open_visits_.size(), {});
  due_.clear();
  settled_.clear();
  Observe(*world_.NextArrival(kNever), 1.0f);
}

StepOutcome PatrolEnvironment::Step(int action) {
  RONDA_CHECK(action >= 0 && action < spec_.num_actions && legal_[action] != 0,
              "action {} of {} is not legal for agent {}", action, spec_.num_actions,
              decision_.agent);
  settled_.clear();
  Pending& chosen = phi_[decision_.agent];
  chosen = {.action = action, .decided_s = world_.time_s(), .index = decision_.index};
  world_.Depart(decision_.agent, encoder_.NextVertex(world_.target(decision_.agent), action));

  const Arrival arrival = *world_.NextArrival(kNever);
  SettleLate(arrival.time_s);
  Arrive(arrival);
  const Pending& before = phi_[arrival.robot];
  const bool first = before.action < 0;
  Observe(arrival,
          first ? 1.0f
                : static_cast<float>(std::exp(-(arrival.time_s - before.decided_s) / horizon_s_)));
  if (arrival.time_s < config_.episode_t_ref * reference_s_) {
    return {.state = EpisodeState::kRunning, .settled = settled_};
  }
  for (OpenVisit& visit : open_visits_) Settle(visit, kNever);
  return {.state = EpisodeState::kCut, .settled = settled_};
}

void PatrolEnvironment::Arrive(const Arrival& arrival) {
  OpenVisit& at_vertex = open_visits_[arrival.vertex];
  Settle(at_vertex, arrival.time_s - at_vertex.visited_s);
  const Pending& pending = phi_[arrival.robot];
  if (pending.action < 0) return;  // a start: nobody decided to come here
  at_vertex = {.agent = arrival.robot,
               .index = pending.index,
               .visited_s = arrival.time_s,
               .visit = {.idleness_s = arrival.idleness_s,
                         .travel_s = arrival.time_s - pending.decided_s,
                         .horizon_s = horizon_s_,
                         .reference_s = reference_s_},
               .open = true};
  if (config_.reward == RewardScheme::kIdleness) {
    Settle(at_vertex, kNever);  // 1 − γ^∞ = 1: the same formula
  } else {
    due_.push_back({arrival.time_s, arrival.vertex});
  }
}

void PatrolEnvironment::Settle(OpenVisit& visit, double until_next_visit_s) {
  if (!visit.open) return;
  visit.open = false;
  settled_.push_back({.agent = visit.agent,
                      .index = visit.index,
                      .reward = HindsightReward(visit.visit, until_next_visit_s)});
}

void PatrolEnvironment::SettleLate(double now_s) {
  while (!due_.empty() && now_s - due_.front().visited_s >= kLatestHorizons * horizon_s_) {
    OpenVisit& visit = open_visits_[due_.front().vertex];
    if (visit.visited_s == due_.front().visited_s) Settle(visit, kNever);
    due_.pop_front();
  }
}

void PatrolEnvironment::Observe(const Arrival& arrival, float discount) {
  const Pending& before = phi_[arrival.robot];
  encoder_.Encode(world_, arrival.robot, observation_, legal_);
  decision_ = {.agent = arrival.robot,
               .index = before.action < 0 ? 0 : before.index + 1,
               .observation = observation_,
               .legal_actions = legal_,
               .discount = discount};
}

}  // namespace ronda
