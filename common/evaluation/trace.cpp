#include "common/evaluation/trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/evaluation/csv_field.h"

namespace ronda {

TraceWriter::TraceWriter(const std::filesystem::path& path, const PatrolGraph& graph,
                         std::string map)
    : file_(path), map_(std::move(map)) {
  for (int vertex = 0; vertex < graph.vertex_count(); ++vertex) {
    vertex_fields_.push_back(CsvField(graph.vertex_id(vertex)));
  }
}

void TraceWriter::Begin(double warmup_s, double window_s) {
  file_.Write(fmt::format("# warmup_s={:.9f} window_s={:.9f} map={}\n", warmup_s, window_s, map_));
  file_.Write("episode,time_s,robot,vertex,event\n");
}

void TraceWriter::Event(int episode, double time_s, int robot, int vertex, std::string_view event) {
  file_.Write(fmt::format("{},{:.9f},{},{},{}\n", episode, time_s, robot,
                          vertex < 0 ? "-1" : vertex_fields_[vertex], event));
}

void TraceWriter::End(int episode, double time_s) {
  file_.Write(fmt::format("{},{:.9f},-1,-1,end\n", episode, time_s));
}

EpisodeTrace::EpisodeTrace(TraceWriter& trace, int episode, std::span<const RobotStart> starts,
                           std::span<const RobotChange> changes)
    : trace_(trace), episode_(episode), starts_(starts), changes_(changes) {
  for (std::size_t robot = 0; robot < starts.size(); ++robot) {
    const auto first = std::ranges::find(changes, static_cast<int>(robot), &RobotChange::robot);
    if (first != changes.end() && first->joins) continue;  // it is not there yet
    trace_.Event(episode_, 0.0, static_cast<int>(robot), starts[robot].vertex, "start");
  }
}

void EpisodeTrace::Visit(const Arrival& arrival) {
  WriteChanges(arrival.time_s);
  if (arrival.time_s == 0.0) return;  // its start
  trace_.Event(episode_, arrival.time_s, arrival.robot, arrival.vertex, "visit");
}

void EpisodeTrace::WriteChanges(double until_s) {
  while (!changes_.empty() && changes_.front().time_s <= until_s) {
    const RobotChange& change = changes_.front();
    trace_.Event(episode_, change.time_s, change.robot,
                 change.joins ? starts_[change.robot].vertex : -1, change.joins ? "join" : "fail");
    changes_ = changes_.subspan(1);
  }
}

void EpisodeTrace::End(double time_s) {
  WriteChanges(time_s);
  trace_.End(episode_, time_s);
}

}  // namespace ronda
