#include "common/evaluation/map_usage.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ronda {
namespace {

/// Somebody was at a vertex: a visit (no longer than a moment) or a stay.
struct Presence {
  double from_s = 0.0;
  double to_s = 0.0;
};

/// Adds up one episode after the other.
class UsageSums {
 public:
  UsageSums(const PatrolGraph& graph, double warmup_s)
      : warmup_s_(warmup_s),
        presences_(graph.vertex_count()),
        idleness_s2_(graph.vertex_count(), 0.0),
        traversals_(graph.edge_count(), 0) {
    for (int e = 0; e < graph.edge_count(); ++e) {
      edge_of_[std::minmax(graph.edges()[e].source, graph.edges()[e].target)] = e;
    }
  }

  void Visit(const TraceEvent& event) {
    const LastSeen& before = event.before;
    const bool stayed = event.vertex == before.vertex;
    presences_[event.vertex].push_back(
        {.from_s = stayed ? before.time_s : event.time_s, .to_s = event.time_s});
    if (!stayed && event.time_s > warmup_s_) {
      ++traversals_[edge_of_.at(std::minmax(before.vertex, event.vertex))];
    }
  }

  void End(double time_s) {
    for (std::size_t v = 0; v < presences_.size(); ++v) {
      std::ranges::sort(presences_[v], {}, &Presence::from_s);
      double idle_since_s = 0.0;
      for (const Presence& presence : presences_[v]) {
        AddIdle(v, idle_since_s, presence.from_s);
        idle_since_s = std::max(idle_since_s, presence.to_s);
      }
      AddIdle(v, idle_since_s, time_s);
      presences_[v].clear();
    }
    ++episodes_;
  }

  MapUsage Means(double window_s) const {
    MapUsage usage;
    const double measured_s = window_s * episodes_;
    for (const double sum_s2 : idleness_s2_) usage.mean_idleness_s.push_back(sum_s2 / measured_s);
    for (const int count : traversals_) {
      usage.traversals_per_hour.push_back(count / measured_s * 3600.0);
    }
    return usage;
  }

 private:
  /// The integral of the idleness of a vertex that nobody visits, as far as it is in the window.
  void AddIdle(std::size_t vertex, double from_s, double to_s) {
    if (to_s <= std::max(from_s, warmup_s_)) return;
    const double first_s = std::max(warmup_s_ - from_s, 0.0);
    const double last_s = to_s - from_s;
    idleness_s2_[vertex] += 0.5 * (last_s - first_s) * (last_s + first_s);
  }

  double warmup_s_;
  std::map<std::pair<int, int>, int> edge_of_;    // by ends, ascending
  std::vector<std::vector<Presence>> presences_;  // (V) in this episode
  std::vector<double> idleness_s2_;               // (V) integrals
  std::vector<int> traversals_;                   // (E)
  int episodes_ = 0;
};

}  // namespace

MapUsage MeasureUsage(TraceReader& trace, const PatrolGraph& graph) {
  UsageSums sums(graph, trace.warmup_s());
  while (const auto event = trace.Next()) {
    if (event->kind == TraceEventKind::kVisit) sums.Visit(*event);
    if (event->kind == TraceEventKind::kEnd) sums.End(event->time_s);
  }
  return sums.Means(trace.window_s());
}

}  // namespace ronda
