#include "common/team/policy_strategy.h"

#include <fmt/format.h>

#include "common/base/check.h"
#include "common/base/error.h"
#include "common/environments/observation_encoder.h"
#include "common/policies/q_policy.h"

namespace ronda {
namespace {

NetworkSpec FitToMap(NetworkSpec spec, const ObservationEncoder& encoder, const PolicyFile& policy,
                     const PatrolGraph& graph) {
  const int observation_size = encoder.observation_size();
  const int num_actions = encoder.num_actions();
  if (spec.kind == NetworkSpec::Kind::kCandidateScorer) {
    spec.observation_size = observation_size;
    spec.num_actions = num_actions;
  } else if (spec.observation_size != observation_size || spec.num_actions != num_actions) {
    throw InputError(fmt::format(
        "the policy was trained on {} and reads {} numbers for {} actions; {} gives {} for {}",
        policy.training.map, spec.observation_size, spec.num_actions, graph.name(),
        observation_size, num_actions));
  }
  return spec;
}

ObservationOptions ObservationOf(const PolicyFile& policy) {
  ObservationOptions options = SchemeOf(policy.spec.schema);
  options.robots = policy.training.agents;
  return options;
}

class PolicyStrategy final : public Strategy {
 public:
  PolicyStrategy(const PolicyFile& policy, const StrategyContext& context)
      : encoder_(*context.graph, *context.paths, ObservationOf(policy)),
        policy_(FitToMap(policy.spec, encoder_, policy, *context.graph)),
        observation_(static_cast<std::size_t>(encoder_.observation_size())),
        legal_(static_cast<std::size_t>(encoder_.num_actions())) {
    WeightSnapshot snapshot;
    snapshot.version = policy.version;
    snapshot.architecture_hash = policy_.architecture_hash();
    snapshot.values = policy.weights;
    const LoadResult result = policy_.Load(snapshot);
    RONDA_CHECK(result == LoadResult::kLoaded, "a checked policy file does not load: {}",
                static_cast<int>(result));
  }

  std::vector<RobotStart> Begin(const PatrolGraph& graph, std::span<const double> speeds_mps,
                                Rng& rng) override {
    const auto robots = static_cast<int>(speeds_mps.size());
    if (encoder_.team_size() > 0 && encoder_.team_size() != robots) {
      throw InputError(fmt::format("the policy observes a team of {} robots, this one has {}",
                                   encoder_.team_size(), robots));
    }
    return Strategy::Begin(graph, speeds_mps, rng);
  }

  Knowledge knowledge() const override { return kObservedKnowledge; }

  int Decide(const Belief& belief, Rng& /*rng*/) override {
    encoder_.Encode(belief, observation_, legal_);
    return encoder_.NextVertex(belief.vertex, policy_.Act(observation_, legal_));
  }

 private:
  ObservationEncoder encoder_;
  QPolicy policy_;
  std::vector<float> observation_;
  std::vector<std::uint8_t> legal_;
};

}  // namespace

std::unique_ptr<Strategy> MakePolicyStrategy(const PolicyFile& policy,
                                             const StrategyContext& context) {
  return std::make_unique<PolicyStrategy>(policy, context);
}

std::unique_ptr<Strategy> LoadPolicyStrategy(const std::filesystem::path& policy_file,
                                             const StrategyContext& context) {
  const PolicyFile policy = ReadPolicyFile(policy_file);
  try {
    return MakePolicyStrategy(policy, context);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", policy_file.string(), error.what()));
  }
}

}  // namespace ronda
