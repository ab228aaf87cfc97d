#pragma once
// What the processes of a run have said of themselves lately, and what that says of the run.
//
// Fed with their reports; asked for the processes, channels and problems of a RunStatus. Rates are
// over the last two seconds of reports, and 0 for a process that is silent. Knows nothing of DDS;
// times are passed in and must not fall. A value; thread-compatible; O(children) a call.
#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "common/rl/messages.h"
#include "deploy/cluster.h"
#include "deploy/run_status.h"

namespace ronda {

class StatusBoard {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// The launcher's own one too, of incarnation 0, for its traffic.
  void OnReport(const ProcessReport& report, TimePoint now);
  /// Fills in `processes`, `channels`, and a problem for each child that is dead, silent, or fails
  /// to write its checkpoint.
  void Fill(const std::vector<ChildFacts>& children, TimePoint now, RunStatus& status) const;
  /// "actor 0: waiting for …, learner: running" of the children that are there.
  std::string WhoWaits(const std::vector<ChildFacts>& children) const;

 private:
  struct Heard {
    TimePoint at;
    std::map<std::string, double> metrics;
  };
  struct Process {
    std::string state;
    std::deque<Heard> heard;  // the last two seconds, oldest first
  };

  double RatePerS(const Process& process, const std::string& metric, TimePoint now) const;
  const Process* Find(std::uint64_t incarnation) const;
  ProcessStatus Describe(const ChildFacts& child, std::uint64_t newest_version,
                         TimePoint now) const;
  std::vector<std::string> ProblemsOf(const ChildFacts& child, const ProcessStatus& process) const;
  void FillChannels(TimePoint now, RunStatus& status) const;

  std::map<std::uint64_t, Process> processes_;  // by incarnation
};

}  // namespace ronda
