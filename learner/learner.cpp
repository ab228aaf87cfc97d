#include "learner/learner.h"

#include <algorithm>

namespace ronda {

Learner::Learner(Algorithm& algorithm, BatchSource& batches, PrioritySink& priorities,
                 WeightSink& weights, const LearnerOptions& options)
    : algorithm_(algorithm),
      batches_(batches),
      priorities_(priorities),
      weights_(weights),
      options_(options) {
  snapshot_.learner_incarnation = options.incarnation;
  snapshot_.version = options.weights_version;
  snapshot_.architecture_hash = algorithm.architecture_hash();
}

int Learner::Step(TimePoint now, std::chrono::milliseconds wait_at_most) {
  if (!published_ || now - last_published_ >= options_.publish_every) Publish(now);
  const SampledBatch* batch = batches_.Next(wait_at_most);
  if (batch == nullptr) return 0;
  last_update_ = algorithm_.Update(*batch);
  MeasureLag(*batch);
  priority_update_.replay_incarnation = batch->replay_incarnation;
  priority_update_.keys = batch->keys;
  priority_update_.priorities.assign(last_update_.absolute_td.begin(),
                                     last_update_.absolute_td.end());
  if (options_.send_priorities) priorities_.Push(priority_update_);
  return 1;
}

void Learner::Publish(TimePoint now) {
  published_ = true;
  last_published_ = now;
  ++snapshot_.version;
  snapshot_.updates = algorithm_.updates();
  const auto parameters = algorithm_.parameters();
  snapshot_.values.assign(parameters.begin(), parameters.end());
  weights_.Publish(snapshot_);
}

void Learner::MeasureLag(const SampledBatch& batch) {
  double sum = 0.0;
  for (const std::uint64_t version : batch.weights_versions) {
    sum += static_cast<double>(snapshot_.version - std::min(version, snapshot_.version));
  }
  policy_lag_versions_ = sum / static_cast<double>(batch.weights_versions.size());
}

}  // namespace ronda
