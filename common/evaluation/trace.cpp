#include "common/evaluation/trace.h"

#include <fmt/format.h>

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

void TraceWriter::Starts(int episode, std::span<const RobotStart> starts) {
  for (std::size_t robot = 0; robot < starts.size(); ++robot) {
    file_.Write(fmt::format("{},{:.9f},{},{},start\n", episode, 0.0, robot,
                            vertex_fields_[starts[robot].vertex]));
  }
}

void TraceWriter::Visit(int episode, const Arrival& arrival) {
  file_.Write(fmt::format("{},{:.9f},{},{},visit\n", episode, arrival.time_s, arrival.robot,
                          vertex_fields_[arrival.vertex]));
}

void TraceWriter::End(int episode, double time_s) {
  file_.Write(fmt::format("{},{:.9f},-1,-1,end\n", episode, time_s));
}

}  // namespace ronda
