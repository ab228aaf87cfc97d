#include "common/world/team_beliefs.h"

#include <cmath>

namespace ronda {
namespace {

double Distance_m(const Position& a, const Position& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

std::vector<std::vector<int>> VerticesWithin(const PatrolGraph& graph, double radius_m) {
  std::vector<std::vector<int>> within(static_cast<std::size_t>(graph.vertex_count()));
  for (int from = 0; from < graph.vertex_count(); ++from) {
    for (int to = 0; to < graph.vertex_count(); ++to) {
      if (Distance_m(graph.positions()[from], graph.positions()[to]) <= radius_m) {
        within[from].push_back(to);
      }
    }
  }
  return within;
}

}  // namespace

Belief CompleteBelief(const PatrolWorld& world, int robot) {
  return {.graph = &world.graph(),
          .time_s = world.time_s(),
          .robot = robot,
          .vertex = world.target(robot),
          .previous_vertex = world.previous_vertex(robot),
          .stay_s = world.stay_s(),
          .speeds_mps = world.speeds_mps(),
          .on_patrol = world.on_patrol(),
          .last_visits_s = world.last_visits_s(),
          .targets = world.targets(),
          .previous_vertices = world.previous_vertices(),
          .expected_arrivals_s = world.expected_arrivals_s()};
}

TeamBeliefs::TeamBeliefs(const PatrolGraph& graph, int robots, const Knowledge& knowledge,
                         const Communication& communication)
    : robots_(static_cast<std::size_t>(robots)),
      vertices_(static_cast<std::size_t>(graph.vertex_count())),
      knowledge_(knowledge),
      communication_(communication) {
  const bool partial = !communication.complete();
  keeps_visits_ = knowledge.visits == Knowledge::Visits::kOwn || (shares_visits() && partial);
  keeps_news_ = partial && (shares_visits() || knowledge.intentions);
  sends_ = keeps_news_ || knowledge.messages;
  if (keeps_visits_) visits_s_.resize(robots_ * vertices_);
  if (!keeps_news_) return;
  news_from_s_.resize(robots_ * robots_);
  targets_.resize(news_from_s_.size());
  previous_.resize(news_from_s_.size());
  arrivals_s_.resize(news_from_s_.size());
  if (communication.observation_radius_m) {
    seen_ = VerticesWithin(graph, *communication.observation_radius_m);
  }
}

void TeamBeliefs::Begin(const PatrolWorld& world, const Rng& messages) {
  rng_ = messages;
  under_way_.clear();
  for (std::size_t entry = 0; entry < visits_s_.size(); ++entry) {
    visits_s_[entry] = world.last_visits_s()[entry % vertices_];
  }
  for (std::size_t entry = 0; entry < news_from_s_.size(); ++entry) {
    news_from_s_[entry] = 0.0;
    SetNews(entry, TruthOf(world, static_cast<int>(entry % robots_)));
  }
}

TeamBeliefs::News TeamBeliefs::TruthOf(const PatrolWorld& world, int robot) {
  return {.target = world.target(robot),
          .previous = world.previous_vertex(robot),
          .arrival_s = world.expected_arrivals_s()[robot]};
}

void TeamBeliefs::SetNews(std::size_t entry, const News& news) {
  targets_[entry] = news.target;
  previous_[entry] = news.previous;
  arrivals_s_[entry] = news.arrival_s;
}

void TeamBeliefs::NoteVisit(int robot, int vertex, double time_s) {
  double& visit_s = visits_s_[VisitRow(robot) + static_cast<std::size_t>(vertex)];
  visit_s = std::max(visit_s, time_s);
}

Belief TeamBeliefs::Arrived(const PatrolWorld& world, const Arrival& arrival) {
  const int robot = arrival.robot;
  while (!under_way_.empty() && under_way_.front().due_s <= arrival.time_s) {
    Deliver(under_way_.front());
    under_way_.pop_front();
  }
  if (keeps_visits_) NoteVisit(robot, arrival.vertex, arrival.time_s);
  if (keeps_news_) {
    LetNewsExpire(world, robot);
    if (!seen_.empty()) See(world, robot);
  }
  Belief belief = CompleteBelief(world, robot);
  if (keeps_visits_) belief.last_visits_s = {&visits_s_[VisitRow(robot)], vertices_};
  if (keeps_news_) {
    belief.targets = {&targets_[TeamRow(robot)], robots_};
    belief.previous_vertices = {&previous_[TeamRow(robot)], robots_};
    belief.expected_arrivals_s = {&arrivals_s_[TeamRow(robot)], robots_};
  }
  if (knowledge_.visits == Knowledge::Visits::kNone) belief.last_visits_s = {};
  if (!knowledge_.intentions) {
    belief.targets = {};
    belief.previous_vertices = {};
    belief.expected_arrivals_s = {};
  }
  return belief;
}

void TeamBeliefs::Departed(const PatrolWorld& world, int robot) {
  const int vertex = world.previous_vertex(robot);
  const bool stays = world.target(robot) == vertex;
  if (keeps_visits_ && stays) NoteVisit(robot, vertex, world.arrival_s(robot));
  if (sends_) Send(world, robot);
}

void TeamBeliefs::Send(const PatrolWorld& world, int robot) {
  const double loss = communication_.loss();
  if (loss >= 1.0) return;
  const Position from = world.position(robot);
  for (int receiver = 0; receiver < static_cast<int>(robots_); ++receiver) {
    if (receiver == robot || world.on_patrol()[receiver] == 0) continue;
    if (loss > 0.0 && rng_.Uniform() < loss) continue;
    if (communication_.message_range_m &&
        Distance_m(from, world.position(receiver)) > *communication_.message_range_m) {
      continue;
    }
    const Message message{.due_s = world.time_s() + communication_.message_delay_s,
                          .sent_s = world.time_s(),
                          .receiver = receiver,
                          .sender = robot,
                          .vertex = world.previous_vertex(robot),
                          .target = world.target(robot),
                          .arrival_s = world.expected_arrivals_s()[robot]};
    if (communication_.message_delay_s > 0.0) {
      under_way_.push_back(message);
    } else {
      Deliver(message);
    }
  }
}

void TeamBeliefs::Deliver(const Message& message) {
  if (keeps_news_) {
    const bool stays = message.target == message.vertex;
    if (shares_visits()) {
      NoteVisit(message.receiver, message.vertex, stays ? message.arrival_s : message.sent_s);
    }
    const std::size_t entry = TeamRow(message.receiver) + message.sender;
    if (message.sent_s >= news_from_s_[entry]) {
      news_from_s_[entry] = message.sent_s;
      SetNews(
          entry,
          {.target = message.target, .previous = message.vertex, .arrival_s = message.arrival_s});
    }
  }
  if (knowledge_.messages && heard_) heard_(message.receiver, message.sender);
}

void TeamBeliefs::LetNewsExpire(const PatrolWorld& world, int robot) {
  for (std::size_t other = 0; other < robots_; ++other) {
    const std::size_t entry = TeamRow(robot) + other;
    const bool was_there = arrivals_s_[entry] < world.time_s();
    if (!was_there && world.on_patrol()[other] != 0) continue;
    if (was_there && shares_visits()) NoteVisit(robot, targets_[entry], arrivals_s_[entry]);
    SetNews(entry, {});
  }
}

void TeamBeliefs::See(const PatrolWorld& world, int robot) {
  if (shares_visits()) {
    for (const int vertex : seen_[world.target(robot)]) {
      visits_s_[VisitRow(robot) + vertex] = world.last_visit_s(vertex);
    }
  }
  const Position from = world.position(robot);
  for (int other = 0; other < static_cast<int>(robots_); ++other) {
    if (other == robot || world.on_patrol()[other] == 0) continue;
    if (Distance_m(from, world.position(other)) > *communication_.observation_radius_m) continue;
    const std::size_t entry = TeamRow(robot) + other;
    news_from_s_[entry] = world.time_s();
    SetNews(entry, TruthOf(world, other));
  }
}

}  // namespace ronda
