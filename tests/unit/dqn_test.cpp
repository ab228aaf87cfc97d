#include "learner/dqn.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "common/base/error.h"
#include "tests/unit/each_kernel.h"
#include "tests/unit/gradient_check.h"

namespace ronda {
namespace {

using testing::LargestGradientError;
using testing::RandomVector;

constexpr std::uint32_t kBatch = 6;

NetworkSpec Scorer() {
  return {.kind = NetworkSpec::Kind::kCandidateScorer,
          .observation_size = 12,
          .num_actions = 3,
          .features = 4,
          .hidden = {7, 6},
          .layer_norm = true,
          .schema = "test"};
}

NetworkSpec Perceptron() {
  return {.kind = NetworkSpec::Kind::kMlp,
          .observation_size = 12,
          .num_actions = 3,
          .hidden = {7, 6},
          .schema = "test"};
}

/// Linear in the observation: Q(s, a) = s·w[:, a] + b[a], so that values can be set by hand.
NetworkSpec Linear(int observation_size, int num_actions) {
  return {.kind = NetworkSpec::Kind::kMlp,
          .observation_size = observation_size,
          .num_actions = num_actions,
          .schema = "test"};
}

SampledBatch EmptyBatch(const NetworkSpec& spec, std::uint32_t count) {
  SampledBatch batch;
  batch.id = 17;
  batch.shape = {.observation_size = static_cast<std::uint32_t>(spec.observation_size),
                 .num_actions = static_cast<std::uint32_t>(spec.num_actions)};
  batch.count = count;
  batch.observations.assign(count * batch.shape.observation_size, 0.0f);
  batch.next_observations = batch.observations;
  batch.actions.assign(count, 0);
  batch.rewards.assign(count, 0.0f);
  batch.discounts.assign(count, 0.0f);
  batch.next_legal_actions.assign(count * batch.shape.num_actions, 1);
  batch.weights_versions.assign(count, 0);
  batch.keys.assign(count, 0);
  batch.importance_weights.assign(count, 1.0f);
  return batch;
}

SampledBatch RandomBatch(const NetworkSpec& spec, Rng& rng) {
  SampledBatch batch = EmptyBatch(spec, kBatch);
  batch.observations = RandomVector<float>(rng, batch.observations.size());
  batch.next_observations = RandomVector<float>(rng, batch.observations.size());
  batch.rewards = RandomVector<float>(rng, kBatch, 2.0);
  for (std::uint32_t i = 0; i < kBatch; ++i) {
    batch.actions[i] = static_cast<std::int32_t>(rng.Below(batch.shape.num_actions));
    batch.discounts[i] = i == 2 ? 0.0f : static_cast<float>(0.5 + 0.5 * rng.Uniform());
    batch.importance_weights[i] = static_cast<float>(0.2 + 0.8 * rng.Uniform());
    batch.next_legal_actions[i * batch.shape.num_actions + rng.Below(3)] = 0;
  }
  return batch;
}

DqnConfig Config(const NetworkSpec& network) { return {.network = network}; }

TEST_CASE("The gradient of the whole loss is that of central differences") {
  for (const NetworkSpec& spec : {Scorer(), Perceptron()}) {
    for (const LossKind kind : {LossKind::kHuber, LossKind::kSquared}) {
      for (const bool double_q : {true, false}) {
        Rng rng(21);
        DqnLoss<double> sut(spec, {.double_q = double_q, .loss = kind, .huber_delta = 1.0});
        const std::size_t count = sut.network().parameter_count();
        auto online = RandomVector(rng, count, 0.7);
        const auto target = RandomVector(rng, count, 0.7);
        const SampledBatch batch = RandomBatch(spec, rng);
        std::vector<double> gradient(count), ignored(count);

        sut.Evaluate(online, target, batch, gradient);

        // y is a constant of the derivative; a step of 1e-5 changes no argmax of this batch, so
        // that it is a constant of the differences as well
        const auto loss = [&] { return sut.Evaluate(online, target, batch, ignored).loss; };
        CHECK(LargestGradientError(loss, online, gradient) < 1e-7);
      }
    }
  }
}

TEST_CASE("The float loss and gradient are those in double, up to rounding") {
  Rng rng(22);
  const SampledBatch batch = RandomBatch(Scorer(), rng);
  DqnLoss<double> exact(Scorer(), {});
  DqnLoss<float> sut(Scorer(), {});
  const std::size_t count = sut.network().parameter_count();
  const auto online = RandomVector<float>(rng, count, 0.7);
  const auto target = RandomVector<float>(rng, count, 0.7);
  std::vector<double> exact_gradient(count);
  std::vector<float> gradient(count);

  const auto expected =
      exact.Evaluate(std::vector<double>(online.begin(), online.end()),
                     std::vector<double>(target.begin(), target.end()), batch, exact_gradient);

  testing::OnEachKernel([&] {
    const auto result = sut.Evaluate(online, target, batch, gradient);

    CHECK(result.loss == Approx(expected.loss).epsilon(1e-4));
    CHECK(result.mean_q == Approx(expected.mean_q).epsilon(1e-4));
    for (std::size_t i = 0; i < count; ++i)
      CHECK(gradient[i] == Approx(exact_gradient[i]).margin(1e-4));
  });
}

/// One state with bias-only values: online and target Q(s', ·), legal actions; gives y.
float TargetOf(bool double_q, const std::vector<float>& online_q,
               const std::vector<float>& target_q, const std::vector<std::uint8_t>& legal,
               float reward, float discount) {
  const int num_actions = static_cast<int>(online_q.size());
  const NetworkSpec spec = Linear(1, num_actions);
  DqnLoss<float> sut(spec, {.double_q = double_q});
  const auto with_bias = [&](const std::vector<float>& bias) {
    std::vector<float> parameters(online_q.size(), 0.0f);  // weights (1, A)
    parameters.insert(parameters.end(), bias.begin(), bias.end());
    return parameters;
  };
  SampledBatch batch = EmptyBatch(spec, 1);
  batch.next_legal_actions = legal;
  batch.rewards[0] = reward;
  batch.discounts[0] = discount;
  std::vector<float> gradient(sut.network().parameter_count());
  sut.Evaluate(with_bias(online_q), with_bias(target_q), batch, gradient);
  return sut.targets()[0];
}

TEST_CASE("Double: the online network chooses the next action, the target network values it") {
  CHECK(TargetOf(true, {1, 5, 3}, {10, 20, 40}, {1, 1, 1}, 2.0f, 0.5f) == 12.0f);
}

TEST_CASE("Not double: the target network's largest value counts") {
  CHECK(TargetOf(false, {1, 5, 3}, {10, 20, 40}, {1, 1, 1}, 2.0f, 0.5f) == 22.0f);
}

TEST_CASE("An illegal next action is never chosen, and ties go to the lowest") {
  CHECK(TargetOf(true, {1, 5, 3}, {10, 20, 40}, {1, 0, 1}, 2.0f, 0.5f) == 22.0f);
  CHECK(TargetOf(false, {1, 5, 3}, {10, 20, 40}, {1, 1, 0}, 2.0f, 0.5f) == 12.0f);
  CHECK(TargetOf(true, {5, 5, 5}, {10, 20, 40}, {0, 1, 1}, 0.0f, 1.0f) == 20.0f);
}

TEST_CASE("Where the discount is 0, nothing of the next state is read") {
  CHECK(TargetOf(true, {1, 5, 3}, {10, 20, 40}, {0, 0, 0}, 2.0f, 0.0f) == 2.0f);
  for (const NetworkSpec& spec : {Scorer(), Perceptron()}) {
    Rng rng(23);
    SampledBatch batch = RandomBatch(spec, rng);
    batch.discounts.assign(kBatch, 0.0f);
    Dqn clean(Config(spec)), sut(Config(spec));
    clean.Update(batch);
    batch.next_observations.assign(batch.next_observations.size(), std::nanf(""));
    batch.next_legal_actions.assign(batch.next_legal_actions.size(), 0);

    sut.Update(batch);

    CHECK(std::vector<float>(sut.parameters().begin(), sut.parameters().end()) ==
          std::vector<float>(clean.parameters().begin(), clean.parameters().end()));
  }
}

TEST_CASE("Importance weights scale loss and gradient of their transitions") {
  const NetworkSpec spec = Linear(1, 1);
  DqnLoss<double> sut(spec, {.loss = LossKind::kSquared});
  SampledBatch batch = EmptyBatch(spec, 2);
  batch.rewards = {1.0f, 10.0f};
  batch.importance_weights = {1.0f, 0.25f};
  const std::vector<double> zero(2);
  std::vector<double> gradient(2);

  const auto result = sut.Evaluate(zero, zero, batch, gradient);

  CHECK(result.loss == Approx((1.0 + 0.25 * 100.0) / 2.0));
  CHECK(gradient[1] == Approx((1.0 * -2.0 + 0.25 * -20.0) / 2.0));  // of the bias
  CHECK(result.mean_absolute_td == Approx(5.5));
  CHECK(sut.absolute_td()[1] == 10.0f);
}

/// Five states in a row, actions left and right; going right from the last pays 1 and ends.
/// Q*(s, right) = γ^(4 − s), Q*(s, left) = γ·max Q*(max(s − 1, 0), ·) = γ^(1 + 4 − max(s − 1, 0)).
TEST_CASE("Learns the optimal values of a corridor of five states") {
  constexpr std::uint32_t kStates = 5;
  constexpr float kGamma = 0.9f;
  const NetworkSpec spec{.kind = NetworkSpec::Kind::kMlp,
                         .observation_size = kStates,
                         .num_actions = 2,
                         .hidden = {32},
                         .schema = "corridor"};
  SampledBatch batch = EmptyBatch(spec, 2 * kStates);
  for (std::uint32_t state = 0; state < kStates; ++state) {
    for (std::uint32_t right = 0; right < 2; ++right) {
      const std::uint32_t i = 2 * state + right;
      const bool ends = right == 1 && state == kStates - 1;
      const std::uint32_t next = right == 1 ? state + 1 : (state == 0 ? 0 : state - 1);
      batch.observations[i * kStates + state] = 1.0f;
      batch.actions[i] = static_cast<std::int32_t>(right);
      batch.rewards[i] = ends ? 1.0f : 0.0f;
      batch.discounts[i] = ends ? 0.0f : kGamma;
      if (!ends) batch.next_observations[i * kStates + next] = 1.0f;
    }
  }
  const auto largest_error = [&](const Dqn& dqn) {
    const QNetwork<float> network(spec);
    QNetwork<float>::Workspace workspace;
    std::vector<float> q(4 * kStates);
    network.Forward(dqn.parameters(), batch.observations, std::vector<std::uint8_t>(q.size(), 1),
                    workspace, q);  // two rows for each state
    double largest = 0.0;
    for (int state = 0; state < static_cast<int>(kStates); ++state) {
      const auto* const values = q.data() + 4 * state;
      const double right = std::pow(kGamma, 4 - state);
      const double left = std::pow(kGamma, 5 - std::max(state - 1, 0));
      largest = std::max({largest, std::abs(values[0] - left), std::abs(values[1] - right)});
    }
    return largest;
  };
  for (const bool double_q : {true, false}) {
    for (const TargetUpdate target_update : {TargetUpdate::kHard, TargetUpdate::kPolyak}) {
      for (const LossKind kind : {LossKind::kHuber, LossKind::kSquared}) {
        Dqn sut({.network = spec,
                 .loss = {.double_q = double_q, .loss = kind},
                 .learning_rate_start = 3e-3,
                 .learning_rate_end = 1e-4,
                 .target_update = target_update,
                 .target_interval = 50,
                 .polyak = 0.02});
        REQUIRE(largest_error(sut) > 0.5);
        constexpr int kUpdates = 3000;
        for (int i = 0; i < kUpdates; ++i) {
          sut.set_progress(static_cast<double>(i) / kUpdates);
          sut.Update(batch);
        }
        INFO("double " << double_q << ", polyak " << (target_update == TargetUpdate::kPolyak));
        CHECK(largest_error(sut) < 0.02);
      }
    }
  }
}

TEST_CASE("A hard target is a copy at every interval and still in between") {
  Rng rng(24);
  const SampledBatch batch = RandomBatch(Scorer(), rng);
  DqnConfig config = Config(Scorer());
  config.target_interval = 3;
  Dqn sut(config);
  const std::vector<float> first(sut.parameters().begin(), sut.parameters().end());
  const auto target = [&] {
    return std::vector<float>(sut.target_parameters().begin(), sut.target_parameters().end());
  };
  const auto online = [&] {
    return std::vector<float>(sut.parameters().begin(), sut.parameters().end());
  };

  sut.Update(batch);
  sut.Update(batch);
  CHECK(target() == first);
  CHECK(online() != first);
  sut.Update(batch);
  CHECK(target() == online());
}

TEST_CASE("A Polyak target moves by its share of the way at every update") {
  Rng rng(25);
  const SampledBatch batch = RandomBatch(Scorer(), rng);
  DqnConfig config = Config(Scorer());
  config.target_update = TargetUpdate::kPolyak;
  config.polyak = 0.25;
  Dqn sut(config);
  const std::vector<float> first(sut.parameters().begin(), sut.parameters().end());

  sut.Update(batch);

  for (std::size_t i = 0; i < first.size(); ++i)
    CHECK(sut.target_parameters()[i] ==
          Approx(0.25 * sut.parameters()[i] + 0.75 * first[i]).margin(1e-6));
}

TEST_CASE("The learning rate is linear in progress, which is clamped") {
  DqnConfig config = Config(Scorer());
  config.learning_rate_start = 1e-3;
  config.learning_rate_end = 1e-4;
  Dqn sut(config);
  CHECK(sut.learning_rate() == Approx(1e-3));
  sut.set_progress(0.5);
  CHECK(sut.learning_rate() == Approx(5.5e-4));
  sut.set_progress(7.0);
  CHECK(sut.learning_rate() == Approx(1e-4));
  sut.set_progress(std::nan(""));
  CHECK(sut.learning_rate() == Approx(1e-4));
}

TEST_CASE("The same seed gives the same weights, another seed others") {
  DqnConfig config = Config(Scorer());
  const Dqn first(config), second(config);
  config.seed = 2;
  const Dqn third(config);
  CHECK(first.Save() == second.Save());
  CHECK(first.Save().vectors[0] != third.Save().vectors[0]);
}

TEST_CASE("A state that was saved and loaded goes on with the same bits") {
  Rng rng(26);
  DqnConfig config = Config(Scorer());
  config.target_interval = 4;
  Dqn original(config);
  original.set_progress(0.3);
  for (int i = 0; i < 3; ++i) original.Update(RandomBatch(Scorer(), rng));
  config.seed = 99;
  Dqn sut(config);

  sut.Load(original.Save());

  CHECK(sut.updates() == 3);
  for (int i = 0; i < 3; ++i) {
    const SampledBatch batch = RandomBatch(Scorer(), rng);
    original.Update(batch);
    sut.Update(batch);
  }
  CHECK(sut.Save() == original.Save());
}

TEST_CASE("A state that does not fit is refused and nothing changes") {
  Dqn sut(Config(Scorer()));
  const AlgorithmState before = sut.Save();
  const auto refused = [&](const auto& spoil, const std::string& words) {
    AlgorithmState state = before;
    state.updates = 5;
    spoil(state);
    CHECK_THROWS_AS(sut.Load(state), CheckpointError);
    CHECK_THROWS_WITH(sut.Load(state), Catch::Matchers::Contains(words));
    CHECK(sut.Save() == before);
  };
  refused([](AlgorithmState& s) { s.algorithm = "ppo"; }, "algorithm \"ppo\"");
  refused([](AlgorithmState& s) { s.architecture_hash ^= 1; }, "architecture");
  refused([](AlgorithmState& s) { s.progress = std::nan(""); }, "progress must be 0 to 1, got nan");
  refused([](AlgorithmState& s) { s.vectors.pop_back(); }, "3 vectors instead of 4");
  refused([](AlgorithmState& s) { s.vectors[1].name.clear(); }, "\"\" instead of \"target\"");
  refused([](AlgorithmState& s) { s.vectors[2].values.pop_back(); }, "\"adam.m\" has");
  refused([](AlgorithmState& s) { s.vectors[3].values[0] = std::nanf(""); }, "not finite");
}

TEST_CASE("A loss that is not finite ends the run with update and mini-batch, weights untouched") {
  Rng rng(27);
  Dqn sut(Config(Scorer()));
  SampledBatch batch = RandomBatch(Scorer(), rng);
  sut.Update(batch);
  const AlgorithmState before = sut.Save();
  batch.rewards[3] = std::numeric_limits<float>::infinity();

  CHECK_THROWS_AS(sut.Update(batch), DivergenceError);
  CHECK_THROWS_WITH(sut.Update(batch),
                    Catch::Matchers::Contains("loss of update 2 (mini-batch 17) is inf"));
  CHECK(sut.Save() == before);
}

TEST_CASE("A mini-batch that does not fit the network is refused") {
  Rng rng(28);
  Dqn sut(Config(Scorer()));
  const auto refused = [&](const auto& spoil, const std::string& words) {
    SampledBatch batch = RandomBatch(Scorer(), rng);
    spoil(batch);
    CHECK_THROWS_AS(sut.Update(batch), InputError);
    CHECK_THROWS_WITH(sut.Update(batch), Catch::Matchers::Contains(words));
  };
  refused([](SampledBatch& b) { b.shape.num_actions = 4; }, "12 and 4 actions");
  refused([](SampledBatch& b) { b.count = 5; }, "lengths do not fit 5 transitions");
  refused([](SampledBatch& b) { b.rewards.pop_back(); }, "lengths do not fit");
  refused([](SampledBatch& b) { b.actions[4] = 3; }, "transition 4 has action 3 of 3");
  refused([](SampledBatch& b) { b.actions[4] = -1; }, "transition 4 has action -1 of 3");
  refused([](SampledBatch& b) { b.next_legal_actions.assign(b.next_legal_actions.size(), 0); },
          "no legal next action");
}

TEST_CASE("A configuration out of range is refused with key, rule and value") {
  const auto refused = [](const auto& spoil, const std::string& words) {
    DqnConfig config = Config(Scorer());
    spoil(config);
    CHECK_THROWS_AS(Dqn(config), InputError);
    CHECK_THROWS_WITH(Dqn(config), Catch::Matchers::Contains(words));
  };
  refused([](DqnConfig& c) { c.learning_rate_start = -1.0; },
          "learning_rate_start must be 0 to 1, got -1");
  refused([](DqnConfig& c) { c.polyak = std::nan(""); }, "polyak must be");
  refused([](DqnConfig& c) { c.target_interval = 0; }, "target_interval must be");
  refused([](DqnConfig& c) { c.network.schema = ""; }, "schema");
}

}  // namespace
}  // namespace ronda
