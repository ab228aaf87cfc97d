#include "common/evaluation/map_usage.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ronda {
namespace {

/// Adds up one episode after the other.
class UsageSums {
 public:
  UsageSums(const PatrolGraph& graph, double warmup_s)
      : warmup_s_(warmup_s),
        last_visit_s_(graph.vertex_count(), 0.0),
        idleness_s2_(graph.vertex_count(), 0.0),
        traversals_(graph.edge_count(), 0) {
    for (int e = 0; e < graph.edge_count(); ++e) {
      edge_of_[std::minmax(graph.edges()[e].source, graph.edges()[e].target)] = e;
    }
  }

  void Start(int vertex) { at_.push_back(vertex); }

  void Visit(int robot, int vertex, double time_s) {
    if (time_s > warmup_s_) ++traversals_[edge_of_.at(std::minmax(at_[robot], vertex))];
    at_[robot] = vertex;
    Close(vertex, time_s);
  }

  void End(double time_s) {
    for (std::size_t v = 0; v < last_visit_s_.size(); ++v) Close(static_cast<int>(v), time_s);
    std::ranges::fill(last_visit_s_, 0.0);
    at_.clear();
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
  /// The integral of the idleness since the last visit, as far as it lies in the window.
  void Close(int vertex, double time_s) {
    const double last_s = std::exchange(last_visit_s_[vertex], time_s);
    if (time_s <= warmup_s_) return;
    const double first_s = std::max(warmup_s_, last_s) - last_s;
    idleness_s2_[vertex] += 0.5 * (time_s - last_s - first_s) * (time_s - last_s + first_s);
  }

  double warmup_s_;
  std::map<std::pair<int, int>, int> edge_of_;  // by ends, ascending
  std::vector<int> at_;                         // (N)
  std::vector<double> last_visit_s_;            // (V)
  std::vector<double> idleness_s2_;             // (V) integrals
  std::vector<int> traversals_;                 // (E)
  int episodes_ = 0;
};

}  // namespace

MapUsage MeasureUsage(TraceReader& trace, const PatrolGraph& graph) {
  UsageSums sums(graph, trace.warmup_s());
  while (const auto event = trace.Next()) {
    switch (event->kind) {
      case TraceEventKind::kStart:
        sums.Start(event->vertex);
        break;
      case TraceEventKind::kVisit:
        sums.Visit(event->robot, event->vertex, event->time_s);
        break;
      case TraceEventKind::kEnd:
        sums.End(event->time_s);
        break;
    }
  }
  return sums.Means(trace.window_s());
}

}  // namespace ronda
