#include "learner/dqn.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "common/base/error.h"
#include "common/nn/loops.h"

namespace ronda {
namespace {

constexpr std::string_view kName = "dqn";

const DqnConfig& Checked(const DqnConfig& config) {
  CheckDqnConfig(config);
  return config;
}

}  // namespace

void CheckDqnConfig(const DqnConfig& config) {
  CheckNetworkSpec(config.network);
  const auto check = [](std::string_view key, double value, double low, double high) {
    if (!(value >= low && value <= high))  // written so that NaN fails
      throw InputError(fmt::format("dqn: {} must be {} to {}, got {}", key, low, high, value));
  };
  check("huber_delta", config.loss.huber_delta, 1e-6, 1e9);
  check("batch_size", config.batch_size, 1, 1 << 20);
  check("learning_rate_start", config.learning_rate_start, 0.0, 1.0);
  check("learning_rate_end", config.learning_rate_end, 0.0, 1.0);
  check("max_gradient_norm", config.max_gradient_norm, 1e-9, 1e9);
  check("target_interval", static_cast<double>(config.target_interval), 1, 1e12);
  check("polyak", config.polyak, 1e-9, 1.0);
  check("adam.beta1", config.adam.beta1, 0.0, 0.999999);
  check("adam.beta2", config.adam.beta2, 0.0, 0.999999);
  check("adam.epsilon", config.adam.epsilon, 1e-12, 1.0);
}

Dqn::Dqn(const DqnConfig& config)
    : config_(Checked(config)),
      loss_(config.network, config.loss),
      online_(loss_.network().parameter_count()),
      gradient_(online_.size()),
      adam_(online_.size(), config.adam) {
  Rng rng(config.seed);
  loss_.network().Initialise(rng, online_);
  target_ = online_;
}

double Dqn::learning_rate() const {
  return config_.learning_rate_start +
         (config_.learning_rate_end - config_.learning_rate_start) * progress_;
}

void Dqn::set_progress(double progress) {
  progress_ = std::isfinite(progress) ? std::clamp(progress, 0.0, 1.0) : progress_;
}

UpdateStats Dqn::Update(const SampledBatch& batch) {
  const auto result = loss_.Evaluate(online_, target_, batch, gradient_);
  const double norm = ClipGradientNorm<float>(config_.max_gradient_norm, gradient_);
  for (const auto& [what, value] : std::array<std::pair<std::string_view, double>, 2>{
           {{"loss", result.loss}, {"gradient norm", norm}}}) {
    if (!std::isfinite(value))
      throw DivergenceError(fmt::format("dqn: the {} of update {} (mini-batch {}) is {}", what,
                                        updates_ + 1, batch.id, value));
  }
  adam_.Step(gradient_, learning_rate(), online_);
  ++updates_;
  UpdateTarget();
  return {.loss = result.loss,
          .mean_absolute_td = result.mean_absolute_td,
          .mean_q = result.mean_q,
          .gradient_norm = norm,
          .absolute_td = loss_.absolute_td()};
}

void Dqn::UpdateTarget() {
  if (config_.target_update == TargetUpdate::kHard) {
    if (updates_ % config_.target_interval == 0) target_ = online_;
    return;
  }
  LoopsInUse().approach(target_.data(), online_.data(), target_.size(),
                        static_cast<float>(config_.polyak));
}

AlgorithmState Dqn::Save() const {
  return {.algorithm = std::string(kName),
          .architecture_hash = architecture_hash(),
          .updates = updates_,
          .optimiser_steps = adam_.state().steps,
          .progress = progress_,
          .vectors = {{"online", online_},
                      {"target", target_},
                      {"adam.m", adam_.state().m},
                      {"adam.v", adam_.state().v}}};
}

void Dqn::Load(const AlgorithmState& state) {
  const auto refuse = [](const std::string& why) {
    throw CheckpointError(fmt::format("dqn: checkpoint does not fit: {}", why));
  };
  if (state.algorithm != kName) refuse(fmt::format("it is of algorithm \"{}\"", state.algorithm));
  if (state.architecture_hash != architecture_hash())
    refuse(fmt::format("architecture {:016x}, but the configuration's is {:016x}",
                       state.architecture_hash, architecture_hash()));
  if (!(state.progress >= 0.0 && state.progress <= 1.0))
    refuse(fmt::format("progress must be 0 to 1, got {}", state.progress));
  constexpr std::array<std::string_view, 4> kNames{"online", "target", "adam.m", "adam.v"};
  if (state.vectors.size() != kNames.size())
    refuse(fmt::format("{} vectors instead of {}", state.vectors.size(), kNames.size()));
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const auto& vector = state.vectors[i];
    if (vector.name != kNames[i])
      refuse(fmt::format("vector {} is \"{}\" instead of \"{}\"", i, vector.name, kNames[i]));
    if (vector.values.size() != online_.size())
      refuse(fmt::format("\"{}\" has {} values instead of {}", vector.name, vector.values.size(),
                         online_.size()));
    if (!std::all_of(vector.values.begin(), vector.values.end(),
                     [](float v) { return std::isfinite(v); }))
      refuse(fmt::format("\"{}\" holds a value that is not finite", vector.name));
  }
  online_ = state.vectors[0].values;
  target_ = state.vectors[1].values;
  adam_.set_state(
      {.m = state.vectors[2].values, .v = state.vectors[3].values, .steps = state.optimiser_steps});
  updates_ = state.updates;
  progress_ = state.progress;
}

}  // namespace ronda
