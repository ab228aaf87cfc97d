#include "learner/learner.h"

#include <catch2/catch.hpp>
#include <vector>

namespace ronda {
namespace {

using std::chrono::milliseconds;

/// Counts its updates; the one weight is that number.
class CountingAlgorithm final : public Algorithm {
 public:
  UpdateStats Update(const SampledBatch& batch) override {
    weight_ = static_cast<float>(++updates_);
    td_.assign(batch.count, weight_);
    UpdateStats stats;
    stats.absolute_td = td_;
    return stats;
  }
  std::span<const float> parameters() const override { return {&weight_, 1}; }
  std::uint64_t architecture_hash() const override { return 42; }
  std::uint64_t updates() const override { return updates_; }
  void set_progress(double) override {}
  AlgorithmState Save() const override { return {}; }
  void Load(const AlgorithmState&) override {}

 private:
  std::uint64_t updates_ = 0;
  float weight_ = 0.0f;
  std::vector<float> td_;
};

class Ports final : public BatchSource, public PrioritySink, public WeightSink {
 public:
  const SampledBatch* Next(milliseconds) override {
    if (batches_left == 0) return nullptr;
    --batches_left;
    return &batch;
  }
  void Push(const PriorityUpdate& update) override { priorities.push_back(update); }
  void Publish(const WeightSnapshot& snapshot) override { published.push_back(snapshot); }

  int batches_left = 0;
  SampledBatch batch;
  std::vector<PriorityUpdate> priorities;
  std::vector<WeightSnapshot> published;
};

TEST_CASE("Weights go out at the first step and then once a period, each version one larger") {
  CountingAlgorithm algorithm;
  Ports ports;
  ports.batch.count = 1;
  ports.batch.weights_versions = {0};
  ports.batches_left = 1000;
  Learner sut(algorithm, ports, ports, ports,
              {.incarnation = 3, .weights_version = 70, .publish_every = milliseconds(100)});
  Learner::TimePoint now{};

  for (int i = 0; i < 30; ++i, now += milliseconds(10)) CHECK(sut.Step(now, milliseconds(0)) == 1);

  REQUIRE(ports.published.size() == 3);
  CHECK(ports.published[0].version == 71);
  CHECK(ports.published[0].updates == 0);
  CHECK(ports.published[2].version == 73);
  CHECK(ports.published[2].updates == 20);
  CHECK(ports.published[2].values == std::vector<float>{20.0f});
  CHECK(ports.published[2].architecture_hash == 42);
}

TEST_CASE("Without a mini-batch nothing is learned, and weights still go out") {
  CountingAlgorithm algorithm;
  Ports ports;
  Learner sut(algorithm, ports, ports, ports, {.publish_every = milliseconds(100)});
  Learner::TimePoint now{};

  CHECK(sut.Step(now, milliseconds(0)) == 0);
  CHECK(sut.Step(now + milliseconds(100), milliseconds(0)) == 0);

  CHECK(algorithm.updates() == 0);
  CHECK(ports.published.size() == 2);
}

TEST_CASE("Priorities go back with their keys where the replay samples by them") {
  CountingAlgorithm algorithm;
  Ports ports;
  ports.batch.replay_incarnation = 5;
  ports.batch.count = 2;
  ports.batch.keys = {8, 9};
  ports.batch.weights_versions = {0, 0};
  ports.batches_left = 1;
  Learner sut(algorithm, ports, ports, ports, {.send_priorities = true});

  sut.Step({}, milliseconds(0));

  REQUIRE(ports.priorities.size() == 1);
  CHECK(ports.priorities[0].replay_incarnation == 5);
  CHECK(ports.priorities[0].keys == std::vector<std::uint64_t>{8, 9});
  CHECK(ports.priorities[0].priorities == std::vector<float>{1.0f, 1.0f});
}

}  // namespace
}  // namespace ronda
