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
constexpr std::uint32_t kVersion = 1;

std::string Encode(const PolicyFile& policy) {
  BoundedOutput out;
  out.Put(static_cast<std::int32_t>(policy.spec.kind));
  out.Put(std::int32_t{policy.spec.observation_size});
  out.Put(std::int32_t{policy.spec.num_actions});
  out.Put(std::int32_t{policy.spec.features});
  out.Put(std::vector<std::int32_t>(policy.spec.hidden.begin(), policy.spec.hidden.end()));
  out.Put(static_cast<std::uint8_t>(policy.spec.layer_norm ? 1 : 0));
  out.Put(policy.spec.schema);
  out.Put(policy.map);
  out.Put(std::int32_t{policy.agents});
  out.Put(policy.training);
  out.Put(policy.version);
  out.Put(policy.updates);
  out.Put(policy.discount_horizon_s);
  out.Put(ArchitectureHash(policy.spec));
  out.Put(policy.weights);
  return out.Bytes();
}

/// What the archive holds; `hash` is the architecture's as it was when the file was written.
PolicyFile Decode(const std::string& payload, std::uint64_t& hash) {
  BoundedInput in(payload);
  PolicyFile policy;
  std::int32_t kind = 0;
  std::uint8_t layer_norm = 0;
  in.Get(kind);
  in.Get(policy.spec.observation_size);
  in.Get(policy.spec.num_actions);
  in.Get(policy.spec.features);
  in.Get(policy.spec.hidden);
  in.Get(layer_norm);
  in.Get(policy.spec.schema);
  in.Get(policy.map);
  in.Get(policy.agents);
  in.Get(policy.training);
  in.Get(policy.version);
  in.Get(policy.updates);
  in.Get(policy.discount_horizon_s);
  in.Get(hash);
  in.Get(policy.weights);
  if (in.Left() != 0) throw std::runtime_error(fmt::format("{} bytes too many", in.Left()));
  if (layer_norm > 1)
    throw std::runtime_error(fmt::format("layer_norm must be 0 or 1, got {}", layer_norm));
  policy.spec.kind = static_cast<NetworkSpec::Kind>(kind);  // CheckPolicy refuses unknown ones
  policy.spec.layer_norm = layer_norm == 1;
  return policy;
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
  if (policy.agents < 0) throw InputError(fmt::format("agents must be ≥ 0, got {}", policy.agents));
  if (!std::isfinite(policy.discount_horizon_s) || policy.discount_horizon_s < 0.0)
    throw InputError(fmt::format("discount_horizon_s must be finite and ≥ 0, got {}",
                                 policy.discount_horizon_s));
}

}  // namespace

void WritePolicyFile(const std::filesystem::path& path, const PolicyFile& policy) {
  try {
    CheckPolicy(policy);
  } catch (const InputError& error) {
    throw CheckpointError(fmt::format("{}: not written: {}", path.string(), error.what()));
  }
  WriteCheckedFile(path, kMagic, kVersion, Encode(policy));
}

PolicyFile ReadPolicyFile(const std::filesystem::path& path) {
  const CheckedFile file = ReadCheckedFile(path, kMagic, kVersion);
  try {
    std::uint64_t hash = 0;
    PolicyFile policy = Decode(file.payload, hash);
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
