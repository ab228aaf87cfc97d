#pragma once
// What each robot of a team knows, kept up with the events of a world.
//
//   beliefs.Begin(world, messages_rng);               // after world.Reset and Schedule
//   while (const auto arrival = world.NextArrival(until_s)) {
//     const Belief belief = beliefs.Arrived(world, *arrival);
//     world.Depart(arrival->robot, …);                // decided from `belief`
//     beliefs.Departed(world, arrival->robot);
//   }
//
// A strategy that shares nothing gets the visits of the robot itself. With complete communication a
// robot that shares gets the world's arrays. Else it has a row of its own of what it has visited,
// heard and seen (conditions.h): the latest news of each robot counts; an announced arrival whose
// time has come counts as a visit, and where that robot goes then is unknown until it is heard
// again. Where everyone starts is known to all; of who is not on patrol nothing is known but that.
//
// O(1) an event where communication is complete, else O(N), and O(N + vertices seen) with a radius;
// O(N·V) memory for own visits, O(N·(N + V)) for incomplete communication, plus the messages under
// way. Copyable; thread-compatible.
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "common/base/rng.h"
#include "common/world/belief.h"
#include "common/world/conditions.h"
#include "common/world/patrol_world.h"

namespace ronda {

/// What a robot that has arrived knows where everyone knows everything at once.
Belief CompleteBelief(const PatrolWorld& world, int robot);

class TeamBeliefs {
 public:
  /// `receiver` has heard what `sender` said when it decided last.
  using HeardFunction = std::function<void(int receiver, int sender)>;

  TeamBeliefs(const PatrolGraph& graph, int robots, const Knowledge& knowledge,
              const Communication& communication);

  /// A new episode of a world that has been reset; `messages` draws which are lost.
  void Begin(const PatrolWorld& world, const Rng& messages);
  /// Called for every message that arrives, where Knowledge says `messages`.
  void OnHeard(HeardFunction heard) { heard_ = std::move(heard); }

  /// Takes in the visit, and what has been heard and is seen; what the arrived robot now knows.
  Belief Arrived(const PatrolWorld& world, const Arrival& arrival);
  /// The robot has decided: tells the others.
  void Departed(const PatrolWorld& world, int robot);

 private:
  struct Message {
    double due_s = 0.0;
    double sent_s = 0.0;
    int receiver = 0;
    int sender = 0;
    int vertex = 0;  // visited when it was sent
    int target = 0;
    double arrival_s = 0.0;
  };

  std::size_t VisitRow(int robot) const { return static_cast<std::size_t>(robot) * vertices_; }
  std::size_t TeamRow(int robot) const { return static_cast<std::size_t>(robot) * robots_; }
  /// What `robot` knows of another from now on; a target of −1: nothing.
  struct News {
    int target = -1;
    int previous = -1;
    double arrival_s = kNever_s;
  };
  static News TruthOf(const PatrolWorld& world, int robot);
  void SetNews(std::size_t entry, const News& news);
  /// `robot` knows that the vertex was visited at `time_s`, or later.
  void NoteVisit(int robot, int vertex, double time_s);
  bool shares_visits() const { return knowledge_.visits == Knowledge::Visits::kShared; }
  void Send(const PatrolWorld& world, int robot);
  void Deliver(const Message& message);
  void See(const PatrolWorld& world, int robot);
  void LetNewsExpire(const PatrolWorld& world, int robot);

  std::size_t robots_;
  std::size_t vertices_;
  Knowledge knowledge_;
  Communication communication_;
  bool keeps_visits_;  // rows of visits: own ones, or what was heard
  bool keeps_news_;    // rows of what was heard of the others
  bool sends_;         // messages have an effect
  HeardFunction heard_;
  Rng rng_{0};
  std::deque<Message> under_way_;       // by due_s
  std::vector<double> visits_s_;        // (N, V)
  std::vector<double> news_from_s_;     // (N, N) when what is known of the other was so
  std::vector<int> targets_;            // (N, N) −1: unknown
  std::vector<int> previous_;           // (N, N) −1: unknown
  std::vector<double> arrivals_s_;      // (N, N)
  std::vector<std::vector<int>> seen_;  // (V) the vertices within the observation radius
};

}  // namespace ronda
