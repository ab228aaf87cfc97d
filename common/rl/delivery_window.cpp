#include "common/rl/delivery_window.h"

#include <algorithm>

#include "common/base/check.h"

namespace ronda {
namespace {

std::uint64_t EndSequence(const TransitionBatch& batch) {
  return batch.first_sequence + batch.count;
}

/// Moves the elements from row `rows` on, of `width` elements each, from one array to another.
template <typename T>
void MoveTail(std::vector<T>& from, std::vector<T>& to, std::size_t rows, std::size_t width) {
  const auto tail = from.begin() + static_cast<std::ptrdiff_t>(rows * width);
  to.assign(tail, from.end());
  from.erase(tail, from.end());
}

/// Cuts `batch` to its first `rows` transitions and returns the rest.
TransitionBatch SplitBatch(TransitionBatch& batch, std::uint32_t rows) {
  TransitionBatch rest;
  rest.actor = batch.actor;
  rest.actor_incarnation = batch.actor_incarnation;
  rest.shape = batch.shape;
  rest.first_sequence = batch.first_sequence + rows;
  rest.count = batch.count - rows;
  batch.count = rows;
  MoveTail(batch.observations, rest.observations, rows, batch.shape.observation_size);
  MoveTail(batch.actions, rest.actions, rows, 1);
  MoveTail(batch.rewards, rest.rewards, rows, 1);
  MoveTail(batch.discounts, rest.discounts, rows, 1);
  MoveTail(batch.next_observations, rest.next_observations, rows, batch.shape.observation_size);
  MoveTail(batch.next_legal_actions, rest.next_legal_actions, rows, batch.shape.num_actions);
  MoveTail(batch.extras, rest.extras, rows, batch.shape.extras_size);
  MoveTail(batch.agents, rest.agents, rows, 1);
  MoveTail(batch.weights_versions, rest.weights_versions, rows, 1);
  return rest;
}

constexpr std::size_t kMaxSpare = 16;    // batches whose memory is kept
constexpr std::size_t kMaxRetired = 16;  // replay incarnations remembered

}  // namespace

DeliveryWindow::DeliveryWindow(const DeliveryOptions& options) : options_(options) {
  RONDA_CHECK(options.batch_size >= 1, "batch_size {}", options.batch_size);
  for (TransitionBatch* batch : {&open_, &announcement_}) {
    batch->actor = options.actor;
    batch->actor_incarnation = options.incarnation;
    batch->shape = options.shape;
  }
}

PushResult DeliveryWindow::Push(const Transition& transition, TimePoint now) {
  if (throttled()) return PushResult::kThrottled;
  if (open_.count == 0) {
    open_.first_sequence = next_sequence_;
    opened_at_ = now;
  }
  open_.Append(transition);
  ++next_sequence_;
  if (open_.count >= options_.batch_size) Flush();
  return PushResult::kAccepted;
}

void DeliveryWindow::Flush() {
  if (open_.count == 0) return;
  TransitionBatch next;
  if (!spare_.empty()) {
    next = std::move(spare_.back());
    spare_.pop_back();
  }
  next.actor = options_.actor;
  next.actor_incarnation = options_.incarnation;
  next.shape = options_.shape;
  held_.push_back(std::move(open_));
  open_ = std::move(next);
  open_.Clear();
}

void DeliveryWindow::OnStatus(const ReplayStatus& status, TimePoint now) {
  if (replay_incarnation_ != status.replay_incarnation && !Adopt(status.replay_incarnation, now)) {
    return;
  }
  heard_at_ = now;
  const auto credit = std::ranges::find_if(status.actors, [&](const ActorCredit& candidate) {
    return candidate.actor == options_.actor && candidate.actor_incarnation == options_.incarnation;
  });
  named_ = credit != status.actors.end();
  if (named_) Confirm(*credit, now);
}

bool DeliveryWindow::Adopt(std::uint64_t incarnation, TimePoint now) {
  const bool retired = std::ranges::find(retired_, incarnation) != retired_.end();
  // A late status of a dead replay must not take us back to it: it would confirm what its
  // successor has never seen. Only a long silence of the successor says that we had them swapped.
  if (retired && now - heard_at_ < options_.replay_silent_after) return false;
  if (replay_incarnation_) {
    retired_.push_back(*replay_incarnation_);
    if (retired_.size() > kMaxRetired) retired_.erase(retired_.begin());
  }
  std::erase(retired_, incarnation);
  replay_incarnation_ = incarnation;
  window_end_ = 0;
  next_ = 0;  // the new replay gets all that is unconfirmed
  progress_at_ = now;
  announced_at_.reset();
  return true;
}

void DeliveryWindow::Confirm(const ActorCredit& credit, TimePoint now) {
  if (credit.stored_through > sent_) return;  // it can't have what was never sent
  window_end_ = std::max(window_end_, credit.window_end);
  if (credit.stored_through <= confirmed_) return;
  confirmed_ = credit.stored_through;
  progress_at_ = now;
  while (!held_.empty() && EndSequence(held_.front()) <= confirmed_ + 1) {
    if (spare_.size() < kMaxSpare) spare_.push_back(std::move(held_.front()));
    held_.pop_front();
    if (next_ > 0) --next_;
  }
}

const TransitionBatch* DeliveryWindow::NextToSend(TimePoint now) {
  announcing_ = false;
  if (open_.count > 0 && now - opened_at_ >= options_.max_age) Flush();
  if (!replay_incarnation_) return nullptr;
  if (!named_) {
    if (announced_at_ && now - *announced_at_ < options_.announce_every) return nullptr;
    announcing_ = true;
    announcement_.replay_incarnation = *replay_incarnation_;
    announcement_.first_sequence = confirmed_ + 1;
    announcement_.oldest_unconfirmed = confirmed_ + 1;
    return &announcement_;
  }
  if (next_ > 0 && now - progress_at_ >= options_.repeat_after) {
    next_ = 0;
    progress_at_ = now;
  }
  if (next_ == held_.size() || held_[next_].first_sequence > window_end_) return nullptr;
  if (EndSequence(held_[next_]) > window_end_ + 1) SplitAtWindow(next_);
  TransitionBatch& batch = held_[next_];
  batch.replay_incarnation = *replay_incarnation_;
  batch.oldest_unconfirmed = confirmed_ + 1;
  return &batch;
}

/// A new replay may grant less than the one before it did: the part of a batch that it has room
/// for must go, or the replay's limiter and this window could wait for each other.
void DeliveryWindow::SplitAtWindow(std::size_t index) {
  TransitionBatch& batch = held_[index];
  const auto rows = static_cast<std::uint32_t>(window_end_ + 1 - batch.first_sequence);
  TransitionBatch rest = SplitBatch(batch, rows);
  held_.insert(held_.begin() + static_cast<std::ptrdiff_t>(index) + 1, std::move(rest));
}

void DeliveryWindow::MarkSent(TimePoint now) {
  if (announcing_) {
    announced_at_ = now;
    announcing_ = false;
    return;
  }
  RONDA_CHECK(next_ < held_.size(), "nothing to mark as sent");
  const TransitionBatch& batch = held_[next_];
  const std::uint64_t last = EndSequence(batch) - 1;
  if (next_ == 0) progress_at_ = now;  // the time-out counts from here
  if (batch.first_sequence <= sent_) repeated_ += std::min(sent_, last) + 1 - batch.first_sequence;
  sent_ = std::max(sent_, last);
  ++next_;
}

}  // namespace ronda
