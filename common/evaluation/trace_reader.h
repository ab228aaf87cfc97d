#pragma once
// Reads what TraceWriter writes, event by event, and trusts none of it.
//
// What comes out fits the graph: episodes 0, 1, …, each with its starts at time 0 (by ascending
// robot); then visits, failures and joinings by ascending time, each visit one edge from where its
// robot was or there again, each failure of one that is on patrol and not the last, each joining of
// one that is not; and the end at warm-up plus window. Anything else, a trace of another map
// included, throws InputError with file, line, rule and value. (An id with a line end in it is
// refused.) 48 MB; a second for some million events. Thread-compatible.
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "common/world/patrol_graph.h"

namespace ronda {

enum class TraceEventKind { kStart, kVisit, kJoin, kFail, kEnd };

/// Where a robot was at its last event, and when that was.
struct LastSeen {
  int vertex = -1;
  double time_s = 0.0;
};

struct TraceEvent {
  int episode = 0;
  double time_s = 0.0;  // since the episode's start
  int robot = 0;        // −1 for kEnd
  int vertex = 0;       // −1 for kFail and kEnd
  TraceEventKind kind = TraceEventKind::kEnd;
  LastSeen before = {};  // kVisit: of this robot
};

class TraceReader {
 public:
  /// `map` as the user names it now: the trace is of this map if that, or the name of `graph`, is
  /// what it says, folder and ending left out. `graph` must outlive the reader.
  TraceReader(const std::filesystem::path& path, const PatrolGraph& graph, const std::string& map);
  ~TraceReader();
  TraceReader(const TraceReader&) = delete;
  TraceReader& operator=(const TraceReader&) = delete;

  double warmup_s() const { return warmup_s_; }
  double window_s() const { return window_s_; }

  /// nullopt after the last episode's end. There is at least one episode.
  std::optional<TraceEvent> Next();

 private:
  class Rows;

  void CheckHeader(const std::string& line, const PatrolGraph& graph, const std::string& map);
  void CheckStart(const TraceEvent& event);
  void CheckVisit(TraceEvent& event);
  void CheckJoin(const TraceEvent& event);
  void CheckFail(const TraceEvent& event);
  void CheckEnd(const TraceEvent& event);

  const PatrolGraph* graph_;
  std::unique_ptr<Rows> rows_;
  double warmup_s_ = 0.0;
  double window_s_ = 0.0;
  int episode_ = 0;
  double time_s_ = 0.0;
  std::map<int, LastSeen> on_patrol_;  // by robot; empty before an episode's starts
  bool has_started_ = false;           // an event after the episode's starts has come
};

}  // namespace ronda
