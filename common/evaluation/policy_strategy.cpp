#include "common/evaluation/policy_strategy.h"

#include <fmt/format.h>

#include "common/base/check.h"
#include "common/base/error.h"
#include "common/environments/observation_encoder.h"
#include "common/policies/q_policy.h"
#include "common/run/paths.h"

namespace ronda {
namespace {

NetworkSpec FitToMap(NetworkSpec spec, const TransitionShape& shape, const PolicyFile& policy,
                     const PatrolGraph& graph) {
  const auto observation_size = static_cast<int>(shape.observation_size);
  const auto num_actions = static_cast<int>(shape.num_actions);
  if (spec.kind == NetworkSpec::Kind::kCandidateScorer) {
    spec.observation_size = observation_size;
    spec.num_actions = num_actions;
  } else if (spec.observation_size != observation_size || spec.num_actions != num_actions) {
    throw InputError(fmt::format(
        "the policy was trained on {} and reads {} numbers for {} actions; {} gives {} for {}",
        policy.map, spec.observation_size, spec.num_actions, graph.name(), observation_size,
        num_actions));
  }
  return spec;
}

class PolicyStrategy final : public Strategy {
 public:
  PolicyStrategy(const PolicyFile& policy, const StrategyContext& context)
      : encoder_(ObservationEncoder::SchemeOf(policy.spec.schema), *context.graph, *context.paths),
        policy_(FitToMap(policy.spec, encoder_.shape(), policy, *context.graph)),
        observation_(encoder_.shape().observation_size),
        legal_(encoder_.shape().num_actions) {
    WeightSnapshot snapshot;
    snapshot.version = policy.version;
    snapshot.architecture_hash = policy_.architecture_hash();
    snapshot.values = policy.weights;
    const LoadResult result = policy_.Load(snapshot);
    RONDA_CHECK(result == LoadResult::kLoaded, "a checked policy file does not load: {}",
                static_cast<int>(result));
  }

  int Decide(const PatrolWorld& world, const Arrival& arrival, Rng& /*rng*/) override {
    encoder_.Encode(world, arrival.robot, observation_, legal_);
    return encoder_.NextVertex(arrival.vertex, policy_.Act(observation_, legal_));
  }

 private:
  ObservationEncoder encoder_;
  QPolicy policy_;
  std::vector<float> observation_;
  std::vector<std::uint8_t> legal_;
};

}  // namespace

std::filesystem::path FindPolicyFile(const std::string& policy) {
  constexpr std::string_view kLatest = "@latest";
  std::error_code error;
  if (std::filesystem::is_regular_file(policy, error)) return policy;
  const bool latest = policy.ends_with(kLatest);
  const std::filesystem::path folder =
      latest ? policy.substr(0, policy.size() - kLatest.size()) : policy;
  if (std::filesystem::is_directory(folder, error)) {
    const auto checkpoints = folder / "checkpoints";
    for (const char* name : {"best.ronda", "latest.ronda"}) {
      if (latest && std::string_view(name) == "best.ronda") continue;
      if (std::filesystem::is_regular_file(checkpoints / name, error)) return checkpoints / name;
    }
    throw InputError(fmt::format("{}: this folder holds no trained policy (checkpoints/{}.ronda)",
                                 folder.string(), latest ? "latest" : "best"));
  }
  const auto shipped = PoliciesFolder() / (policy + ".ronda");
  if (std::filesystem::is_regular_file(shipped, error)) return shipped;
  throw InputError(
      fmt::format("no policy '{}': neither a policy file, nor a run folder, nor the name of a "
                  "policy that ships",
                  policy));
}

std::unique_ptr<Strategy> MakePolicyStrategy(const PolicyFile& policy,
                                             const StrategyContext& context) {
  return std::make_unique<PolicyStrategy>(policy, context);
}

}  // namespace ronda
