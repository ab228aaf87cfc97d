#pragma once
// The events of an evaluation as CSV, from which anyone can recompute its figures.
//
// First line `# warmup_s=… window_s=… map=…`, then the header and one row an event:
// `episode,time_s,robot,vertex,event`. Episodes and robots count from 0; vertices stand by their
// ids in the map; time runs from the episode's start, warm-up included, with 9 decimals. Events:
// `start` (time 0, counts as a visit; a robot that starts on an edge names the vertex behind it),
// `visit` (a robot that stays put visits the same vertex again at the end of its stay, and was
// there all the while), `join` (at the vertex where it starts; the visit follows), `fail` (vertex
// −1), and `end` (one an episode, at the end time, robot and vertex −1). Errors as OutputFile.
// Thread-compatible.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "common/evaluation/output_file.h"
#include "common/world/patrol_world.h"

namespace ronda {

class TraceWriter {
 public:
  /// `map` as the user named it. `graph` must outlive the writer.
  TraceWriter(const std::filesystem::path& path, const PatrolGraph& graph, std::string map);

  /// Once, before the first episode.
  void Begin(double warmup_s, double window_s);
  void Event(int episode, double time_s, int robot, int vertex, std::string_view event);
  void End(int episode, double time_s);
  /// Everything is written: gives the file its name.
  void Commit() { file_.Commit(); }

 private:
  OutputFile file_;
  std::string map_;
  std::vector<std::string> vertex_fields_;  // (V) ids, quoted where CSV wants it
};

/// One episode's rows: visits as they come, failures and joinings at their times between them.
class EpisodeTrace {
 public:
  /// All must outlive it.
  EpisodeTrace(TraceWriter& trace, int episode, std::span<const RobotStart> starts,
               std::span<const RobotChange> changes);

  void Visit(const Arrival& arrival);
  void End(double time_s);

 private:
  void WriteChanges(double until_s);

  TraceWriter& trace_;
  int episode_;
  std::span<const RobotStart> starts_;
  std::span<const RobotChange> changes_;  // not written yet
};

}  // namespace ronda
