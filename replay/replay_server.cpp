#include "replay/replay_server.h"

#include <fmt/format.h>

#include <algorithm>

namespace ronda {

ReplayServer::ReplayServer(const ReplayServerConfig& config, std::uint64_t incarnation,
                           const Rng& rng)
    : config_(config),
      incarnation_(incarnation),
      rng_(rng),
      buffer_(config.shape, static_cast<std::size_t>(config.capacity)),
      sampler_(config.sampler, config.capacity),
      limiter_(config.rate_limiter, config.batch_size),
      ledger_(incarnation) {}

void ReplayServer::Insert(const TransitionBatch& batch) {
  if (batch.shape != config_.shape) {
    ++messages_refused_;
    const std::pair sender{batch.actor, batch.actor_incarnation};
    if (std::find(refused_senders_.begin(), refused_senders_.end(), sender) ==
        refused_senders_.end()) {
      refused_senders_.push_back(sender);
      refusals_.push_back(fmt::format(
          "actor {}: refused: transitions of {} observation floats, {} actions, {} extras; this "
          "run has {}, {}, {}",
          batch.actor, batch.shape.observation_size, batch.shape.num_actions,
          batch.shape.extras_size, config_.shape.observation_size, config_.shape.num_actions,
          config_.shape.extras_size));
    }
    return;
  }
  const std::uint32_t repeated = ledger_.Accept(batch);
  for (std::uint32_t row = repeated; row < batch.count; ++row) {
    sampler_.Inserted(buffer_, buffer_.Insert(batch, row));
    limiter_.Inserted(1);
  }
}

void ReplayServer::Request(const SampleRequest& request) {
  if (request.batch_size != config_.batch_size) {
    ++messages_refused_;
    return;
  }
  const bool same_learner =
      request_ && request_->learner_incarnation == request.learner_incarnation;
  if (request_ && request_->learner_incarnation > request.learner_incarnation) return;
  next_id_ = same_learner ? std::max(next_id_, request.first_id) : request.first_id;
  request_ = request;
}

void ReplayServer::Reprioritise(const PriorityUpdate& update) {
  if (update.replay_incarnation == incarnation_) sampler_.Update(buffer_, update);
}

const SampledBatch* ReplayServer::NextBatch() {
  samples_wait_ = false;
  if (!request_ || next_id_ >= request_->end_id) return nullptr;
  if (!limiter_.CanSample(config_.batch_size, buffer_.size())) {
    samples_wait_ = true;
    return nullptr;
  }
  sampler_.Sample(buffer_, config_.batch_size, rng_, batch_);
  limiter_.Sampled(config_.batch_size);
  batch_.replay_incarnation = incarnation_;
  batch_.learner_incarnation = request_->learner_incarnation;
  batch_.id = next_id_++;
  return &batch_;
}

std::uint64_t ReplayServer::LargestWindow() const {
  // All windows together take at most half of the limiter's band, so promises to a dead actor never
  // stop the others.
  const double half_band =
      config_.rate_limiter.error_buffer / config_.rate_limiter.samples_per_insert;
  const double share =
      half_band / static_cast<double>(std::max<std::size_t>(1, ledger_.wanted_actors()));
  return std::max<std::uint64_t>(1, std::min(config_.window, static_cast<std::uint64_t>(share)));
}

ReplayStatus ReplayServer::Status() {
  const std::uint64_t room = limiter_.InsertRoom();
  ledger_.Grant(room, LargestWindow());
  ReplayStatus status;
  status.replay_incarnation = incarnation_;
  status.size = buffer_.size();
  status.capacity = buffer_.capacity();
  status.stored = limiter_.inserted();
  status.sampled = limiter_.sampled();
  status.repeats_dropped = ledger_.repeats_dropped();
  status.doubled = limiter_.inserted() - std::min(limiter_.inserted(), ledger_.stored());
  status.messages_refused = messages_refused_;
  status.inserts_wait = room < config_.batch_size ? 1 : 0;
  status.samples_wait = samples_wait_ ? 1 : 0;
  status.actors = ledger_.Credits();
  return status;
}

std::vector<std::string> ReplayServer::TakeRefusals() { return std::exchange(refusals_, {}); }

}  // namespace ronda
