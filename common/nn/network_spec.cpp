#include "common/nn/network_spec.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "common/base/error.h"
#include "common/nn/parameters.h"

namespace ronda {
namespace {

constexpr int kMaxSize = 1 << 20;
constexpr std::size_t kMaxLayers = 16;
constexpr std::size_t kMaxSchemaLength = 64;
constexpr std::size_t kMaxParameters = std::size_t{1} << 26;

void CheckSize(std::string_view what, int size) {
  if (size < 1 || size > kMaxSize)
    throw InputError(fmt::format("network: {} must be 1 to {}, got {}", what, kMaxSize, size));
}

void CheckSchema(const std::string& schema) {
  constexpr std::string_view kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
  if (schema.empty() || schema.size() > kMaxSchemaLength ||
      schema.find_first_not_of(kAllowed) != std::string::npos)
    throw InputError(
        fmt::format("network: schema must be 1 to {} letters, digits, '-', '_' or '.', got {} "
                    "characters \"{}\"",
                    kMaxSchemaLength, schema.size(), schema.substr(0, kMaxSchemaLength)));
}

}  // namespace

void CheckNetworkSpec(const NetworkSpec& spec) {
  CheckSize("observation_size", spec.observation_size);
  CheckSize("num_actions", spec.num_actions);
  if (spec.kind == NetworkSpec::Kind::kCandidateScorer) {
    CheckSize("features", spec.features);
    if (std::int64_t{spec.num_actions} * spec.features != spec.observation_size)
      throw InputError(fmt::format(
          "network: a scorer's observation_size must be num_actions × features = {} × {}, got {}",
          spec.num_actions, spec.features, spec.observation_size));
  } else if (spec.kind != NetworkSpec::Kind::kMlp) {
    throw InputError(fmt::format("network: unknown kind {}", static_cast<int>(spec.kind)));
  }
  if (spec.hidden.size() > kMaxLayers)
    throw InputError(
        fmt::format("network: at most {} hidden layers, got {}", kMaxLayers, spec.hidden.size()));
  for (const int width : spec.hidden) CheckSize("a hidden layer's width", width);
  CheckSchema(spec.schema);
  if (const std::size_t count = ParameterCount(spec); count > kMaxParameters)
    throw InputError(
        fmt::format("network: at most {} parameters, these layers have {}", kMaxParameters, count));
}

std::string DescribeArchitecture(const NetworkSpec& spec) {
  const std::string sizes =
      spec.kind == NetworkSpec::Kind::kCandidateScorer
          ? fmt::format("features={}", spec.features)
          : fmt::format("observation={} actions={}", spec.observation_size, spec.num_actions);
  return fmt::format("{} schema={} {} hidden={} layer_norm={} activation=relu format=1",
                     spec.kind == NetworkSpec::Kind::kCandidateScorer ? "scorer" : "mlp",
                     spec.schema, sizes, fmt::join(spec.hidden, ","), spec.layer_norm ? 1 : 0);
}

std::uint64_t ArchitectureHash(const NetworkSpec& spec) {
  return Hash64(DescribeArchitecture(spec));
}

MlpSpec PerceptronOf(const NetworkSpec& spec) {
  const bool scorer = spec.kind == NetworkSpec::Kind::kCandidateScorer;
  return {.inputs = scorer ? spec.features : spec.observation_size,
          .hidden = spec.hidden,
          .outputs = scorer ? 1 : spec.num_actions,
          .layer_norm = spec.layer_norm};
}

std::size_t ParameterCount(const NetworkSpec& spec) {
  const MlpSpec mlp = PerceptronOf(spec);
  std::size_t count = 0;
  auto inputs = static_cast<std::size_t>(mlp.inputs);
  for (const int width : mlp.hidden) {
    const auto outputs = static_cast<std::size_t>(width);
    count += inputs * outputs + outputs * (mlp.layer_norm ? 3 : 1);
    inputs = outputs;
  }
  return count + (inputs + 1) * static_cast<std::size_t>(mlp.outputs);
}

}  // namespace ronda
