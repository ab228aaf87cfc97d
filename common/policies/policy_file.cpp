#include "common/policies/policy_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "common/base/bounded_archive.h"
#include "common/base/checked_file.h"
#include "common/base/error.h"

namespace ronda {
namespace {

constexpr std::string_view kMagic = "RONDAPOL";
constexpr std::size_t kMaxTextSize = 1024;

void PutSpec(BoundedOutput& out, const NetworkSpec& spec) {
  out.Put(static_cast<std::int32_t>(spec.kind));
  out.Put(std::int32_t{spec.observation_size});
  out.Put(std::int32_t{spec.num_actions});
  out.Put(std::int32_t{spec.features});
  out.Put(std::vector<std::int32_t>(spec.hidden.begin(), spec.hidden.end()));
  out.Put(static_cast<std::uint8_t>(spec.layer_norm ? 1 : 0));
  out.Put(spec.schema);
}

NetworkSpec GetSpec(BoundedInput& in) {
  NetworkSpec spec;
  std::int32_t kind = 0;
  std::uint8_t layer_norm = 0;
  in.Get(kind);
  in.Get(spec.observation_size);
  in.Get(spec.num_actions);
  in.Get(spec.features);
  in.Get(spec.hidden);
  in.Get(layer_norm);
  in.Get(spec.schema);
  if (layer_norm > 1)
    throw std::runtime_error(fmt::format("layer_norm must be 0 or 1, got {}", layer_norm));
  spec.kind = static_cast<NetworkSpec::Kind>(kind);  // CheckPolicy refuses unknown ones
  spec.layer_norm = layer_norm == 1;
  return spec;
}

void PutFacts(BoundedOutput& out, const TrainingFacts& facts) {
  out.Put(facts.map);
  out.Put(std::int32_t{facts.agents});
  out.Put(facts.speed_mps);
  out.Put(facts.algorithm);
  out.Put(facts.seed);
  out.Put(facts.reward);
  out.Put(facts.discount_horizon_s);
  out.Put(facts.decisions);
  out.Put(facts.training_s);
  out.Put(facts.agi_s);
  out.Put(facts.agi_ci95_s);
  out.Put(facts.ronda_version);
}

TrainingFacts GetFacts(BoundedInput& in) {
  TrainingFacts facts;
  in.Get(facts.map);
  in.Get(facts.agents);
  in.Get(facts.speed_mps);
  in.Get(facts.algorithm);
  in.Get(facts.seed);
  in.Get(facts.reward);
  in.Get(facts.discount_horizon_s);
  in.Get(facts.decisions);
  in.Get(facts.training_s);
  in.Get(facts.agi_s);
  in.Get(facts.agi_ci95_s);
  in.Get(facts.ronda_version);
  return facts;
}

std::string Encode(const PolicyFile& policy) {
  BoundedOutput out;
  PutSpec(out, policy.spec);
  PutFacts(out, policy.training);
  out.Put(policy.version);
  out.Put(policy.updates);
  out.Put(ArchitectureHash(policy.spec));
  out.Put(policy.weights);
  return out.Bytes();
}

/// What stands between network and hash in format 1, which knew fewer facts; algorithm and seed
/// were one text there.
void GetFormat1(BoundedInput& in, PolicyFile& policy) {
  in.Get(policy.training.map);
  in.Get(policy.training.agents);
  in.Get(policy.training.algorithm);
  in.Get(policy.version);
  in.Get(policy.updates);
  in.Get(policy.training.discount_horizon_s);
}

/// What the archive holds; `hash` is the architecture's as it was when the file was written.
PolicyFile Decode(const CheckedFile& file, std::uint64_t& hash) {
  BoundedInput in(file.payload);
  PolicyFile policy;
  policy.format = file.version;
  policy.spec = GetSpec(in);
  if (file.version == 1) {
    GetFormat1(in, policy);
  } else {
    policy.training = GetFacts(in);
    in.Get(policy.version);
    in.Get(policy.updates);
  }
  in.Get(hash);
  in.Get(policy.weights);
  if (in.Left() != 0) throw std::runtime_error(fmt::format("{} bytes too many", in.Left()));
  return policy;
}

/// Throws InputError naming rule and value.
void CheckFacts(const TrainingFacts& facts) {
  const auto check_text = [](std::string_view name, const std::string& text) {
    const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7F; };
    if (text.size() > kMaxTextSize || std::any_of(text.begin(), text.end(), is_control))
      throw InputError(fmt::format("{} must be at most {} bytes without control characters", name,
                                   kMaxTextSize));
  };
  const auto check_number = [](std::string_view name, double value) {
    if (!std::isfinite(value) || value < 0.0)
      throw InputError(fmt::format("{} must be finite and ≥ 0, got {}", name, value));
  };
  check_text("map", facts.map);
  check_text("algorithm", facts.algorithm);
  check_text("reward", facts.reward);
  check_text("ronda_version", facts.ronda_version);
  check_number("speed_mps", facts.speed_mps);
  check_number("discount_horizon_s", facts.discount_horizon_s);
  check_number("training_s", facts.training_s);
  check_number("agi_s", facts.agi_s);
  check_number("agi_ci95_s", facts.agi_ci95_s);
  if (facts.agents < 0) throw InputError(fmt::format("agents must be ≥ 0, got {}", facts.agents));
  if (facts.seed < -1) throw InputError(fmt::format("seed must be ≥ −1, got {}", facts.seed));
}

/// Throws InputError naming rule and value.
void CheckPolicy(const PolicyFile& policy) {
  CheckNetworkSpec(policy.spec);
  if (const std::size_t count = ParameterCount(policy.spec); policy.weights.size() != count)
    throw InputError(
        fmt::format("its network has {} weights, it holds {}", count, policy.weights.size()));
  const auto bad = std::find_if_not(policy.weights.begin(), policy.weights.end(),
                                    [](float weight) { return std::isfinite(weight); });
  if (bad != policy.weights.end())
    throw InputError(
        fmt::format("weight {} must be finite, got {}", bad - policy.weights.begin(), *bad));
  CheckFacts(policy.training);
}

}  // namespace

void WritePolicyFile(const std::filesystem::path& path, const PolicyFile& policy) {
  try {
    CheckPolicy(policy);
  } catch (const InputError& error) {
    throw CheckpointError(fmt::format("{}: not written: {}", path.string(), error.what()));
  }
  WriteCheckedFile(path, kMagic, kPolicyFormat, Encode(policy));
}

PolicyFile ReadPolicyFile(const std::filesystem::path& path) {
  const CheckedFile file = ReadCheckedFile(path, kMagic, kPolicyFormat);
  try {
    std::uint64_t hash = 0;
    PolicyFile policy = Decode(file, hash);
    CheckPolicy(policy);
    if (hash != ArchitectureHash(policy.spec))
      throw InputError(fmt::format("architecture {:016x} instead of {:016x} for \"{}\"", hash,
                                   ArchitectureHash(policy.spec),
                                   DescribeArchitecture(policy.spec)));
    return policy;
  } catch (const std::exception& error) {  // cereal's, or of a check above
    throw CheckpointError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

}  // namespace ronda
