#pragma once
// A replay without a process: the real endpoint and the real server, and a record of what was
// stored.
//
// `Step` is one turn of ronda-replay's loop. The participant must outlive it. Thread-compatible;
// SmallReplayThread runs one on a thread of its own.
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "common/dds/participant.h"
#include "common/dds/replay_endpoint.h"
#include "replay/replay_server.h"

namespace ronda {

/// A configuration whose limiter holds nobody up; shape kShape.
ReplayServerConfig UnlimitedReplay();

class SmallReplay {
 public:
  /// Told of the reward of each transition that was stored, in order.
  using Record = std::function<void(float reward)>;

  SmallReplay(dds::Participant& participant, const ReplayServerConfig& config,
              std::uint64_t incarnation, Record record);

  /// Takes what has come, sends what is due, waits up to 5 ms where nothing came.
  void Step();
  ReplayStatus Status();
  std::vector<std::string> TakeRefusals() { return endpoint_.TakeRefusals(); }

 private:
  void Insert();

  dds::ReplayEndpoint endpoint_;
  ReplayServer server_;
  Record record_;
  TransitionBatch batch_;
};

/// A small replay that serves until `Stop` or its destruction, as a participant of its own.
class SmallReplayThread {
 public:
  SmallReplayThread(const dds::ParticipantOptions& options, const ReplayServerConfig& config,
                    std::uint64_t incarnation);
  ~SmallReplayThread() { Stop(); }

  void Stop();
  // After Stop:
  const std::vector<float>& stored_rewards() const { return stored_; }
  const ReplayStatus& last_status() const { return last_status_; }
  const std::vector<std::string>& refusals() const { return refusals_; }

 private:
  std::vector<float> stored_;
  ReplayStatus last_status_;
  std::vector<std::string> refusals_;
  std::jthread thread_;
};

}  // namespace ronda
