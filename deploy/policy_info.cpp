#include "deploy/policy_info.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "common/run/duration.h"

namespace ronda {
namespace {

using Json = nlohmann::ordered_json;

bool IsScorer(const NetworkSpec& spec) { return spec.kind == NetworkSpec::Kind::kCandidateScorer; }

std::string FormatNetwork(const NetworkSpec& spec) {
  std::string layers = IsScorer(spec)
                           ? fmt::format("scorer of candidates, {} features", spec.features)
                           : fmt::format("perceptron, {} numbers", spec.observation_size);
  for (const int width : spec.hidden) layers += fmt::format(" → {}", width);
  layers += IsScorer(spec) ? " → 1" : fmt::format(" → {}", spec.num_actions);
  return fmt::format("{}, relu{}, {} parameters", layers, spec.layer_norm ? ", LayerNorm" : "",
                     ParameterCount(spec));
}

std::string FormatTeam(const TrainingFacts& facts) {
  std::vector<std::string> parts = {facts.map.empty() ? "a map that is not named" : facts.map};
  parts.push_back(facts.agents > 0 ? fmt::format("{} robots", facts.agents) : "several team sizes");
  if (facts.speed_mps > 0.0) parts.push_back(fmt::format("{} m/s", facts.speed_mps));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string FormatTraining(const PolicyFile& policy) {
  const TrainingFacts& facts = policy.training;
  std::vector<std::string> parts;
  if (!facts.algorithm.empty()) parts.push_back(facts.algorithm);
  if (facts.seed >= 0) parts.push_back(fmt::format("seed {}", facts.seed));
  parts.push_back(fmt::format("{} updates", policy.updates));
  if (facts.decisions > 0) parts.push_back(fmt::format("{} decisions", facts.decisions));
  if (facts.training_s > 0.0) parts.push_back(FormatDuration(facts.training_s));
  parts.push_back(fmt::format("weights version {}", policy.version));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// null where it is not known.
Json Known(const std::string& text) { return text.empty() ? Json() : Json(text); }
template <class Number>
Json Known(Number number) {
  return number > 0 ? Json(number) : Json();
}

}  // namespace

std::string FormatPolicy(const std::filesystem::path& path, const PolicyFile& policy) {
  const TrainingFacts& facts = policy.training;
  std::string text = fmt::format("{}\n", path.string());
  const auto add = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:<13}{}\n", name, value);
  };
  add("network", FormatNetwork(policy.spec));
  add("architecture", fmt::format("{:016x}", ArchitectureHash(policy.spec)));
  add("observation", policy.spec.schema);
  add("trained on", FormatTeam(facts));
  add("training", FormatTraining(policy));
  if (!facts.reward.empty()) add("reward", facts.reward);
  if (facts.discount_horizon_s > 0.0)
    add("horizon", fmt::format("{:.4g} s", facts.discount_horizon_s));
  if (facts.agi_s > 0.0) {
    add("judged", fmt::format("AGI {:.2f} ± {:.2f} s (as trained; steady protocol, 20 episodes)",
                              facts.agi_s, facts.agi_ci95_s));
  }
  add("file",
      fmt::format("format {}, {} bytes{}", policy.format, std::filesystem::file_size(path),
                  facts.ronda_version.empty() ? "" : ", trained by ronda " + facts.ronda_version));
  return text;
}

std::string PolicyAsJson(const std::filesystem::path& path, const PolicyFile& policy) {
  const TrainingFacts& facts = policy.training;
  Json json;
  json["file"] = path.string();
  json["format"] = policy.format;
  json["size_bytes"] = std::filesystem::file_size(path);
  json["network"] = {{"kind", IsScorer(policy.spec) ? "scorer" : "mlp"},
                     {"observation_size", policy.spec.observation_size},
                     {"num_actions", policy.spec.num_actions},
                     {"features", Known(policy.spec.features)},
                     {"hidden", policy.spec.hidden},
                     {"layer_norm", policy.spec.layer_norm},
                     {"activation", "relu"},
                     {"parameters", ParameterCount(policy.spec)}};
  json["architecture_hash"] = fmt::format("{:016x}", ArchitectureHash(policy.spec));
  json["observation_schema"] = policy.spec.schema;
  json["map"] = Known(facts.map);
  json["agents"] = Known(facts.agents);
  json["speed_mps"] = Known(facts.speed_mps);
  json["algorithm"] = Known(facts.algorithm);
  json["seed"] = facts.seed >= 0 ? Json(facts.seed) : Json();
  json["reward"] = Known(facts.reward);
  json["discount_horizon_s"] = Known(facts.discount_horizon_s);
  json["updates"] = policy.updates;
  json["decisions"] = Known(facts.decisions);
  json["training_s"] = Known(facts.training_s);
  json["weights_version"] = policy.version;
  json["agi_s"] =
      facts.agi_s > 0.0 ? Json{{"mean", facts.agi_s}, {"ci95", facts.agi_ci95_s}} : Json();
  json["ronda_version"] = Known(facts.ronda_version);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ronda
