#include "tests/dds/small_replay.h"

#include <utility>

#include "tests/dds/values.h"

namespace ronda {

using std::chrono::milliseconds;

ReplayServerConfig UnlimitedReplay() {
  ReplayServerConfig config;
  config.shape = kShape;
  config.capacity = 100'000;
  config.batch_size = 64;
  config.window = 1024;
  config.rate_limiter = {.min_size = 1, .samples_per_insert = 1.0, .error_buffer = 1e9};
  return config;
}

SmallReplay::SmallReplay(dds::Participant& participant, const ReplayServerConfig& config,
                         std::uint64_t incarnation, Record record)
    : endpoint_(participant),
      server_(config, incarnation, SplitSeed(7, incarnation)),
      record_(std::move(record)) {}

void SmallReplay::Insert() {
  const std::uint64_t before = server_.Status().stored;
  server_.Insert(batch_);
  const std::uint64_t added = server_.Status().stored - before;
  // The server stores the last ones of a batch: what it skips are repeats, which lead.
  for (std::uint64_t row = batch_.count - added; row < batch_.count; ++row) {
    record_(batch_.rewards[row]);
  }
}

void SmallReplay::Step() {
  constexpr int kMost = 64;  // then it is time to say what is stored
  int messages = 0;
  for (; messages < kMost && endpoint_.TakeBatch(batch_); ++messages) Insert();
  SampleRequest request;
  for (; endpoint_.TakeRequest(request); ++messages) server_.Request(request);
  PriorityUpdate priorities;
  for (; endpoint_.TakePriorities(priorities); ++messages) server_.Reprioritise(priorities);
  while (const SampledBatch* batch = server_.NextBatch()) {
    ++messages;
    if (!endpoint_.SendBatch(*batch)) break;
  }
  endpoint_.SendStatus(Status());
  if (messages == 0) endpoint_.Wait(milliseconds(5));
}

ReplayStatus SmallReplay::Status() {
  ReplayStatus status = server_.Status();
  status.messages_refused += endpoint_.messages_refused();
  return status;
}

SmallReplayThread::SmallReplayThread(const dds::ParticipantOptions& options,
                                     const ReplayServerConfig& config, std::uint64_t incarnation)
    : thread_([this, options, config, incarnation](std::stop_token stop) {
        dds::Participant participant(options);
        SmallReplay replay(participant, config, incarnation,
                           [this](float reward) { stored_.push_back(reward); });
        while (!stop.stop_requested()) replay.Step();
        last_status_ = replay.Status();
        refusals_ = replay.TakeRefusals();
      }) {}

void SmallReplayThread::Stop() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

}  // namespace ronda
