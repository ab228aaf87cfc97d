#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "common/base/checked_file.h"
#include "common/base/error.h"
#include "common/base/whole_file.h"
#include "common/policies/policy_file.h"
#include "common/policies/q_policy.h"
#include "tests/temporary_folder.h"
#include "tests/unit/gradient_check.h"

namespace ronda {
namespace {

using Catch::Matchers::Contains;
using testing::RandomVector;

/// Q(s, a) = s·w[:, a] + b[a]
NetworkSpec Linear(int num_actions) {
  return {.kind = NetworkSpec::Kind::kMlp,
          .observation_size = 1,
          .num_actions = num_actions,
          .schema = "test"};
}

NetworkSpec Scorer(int num_actions) {
  return {.kind = NetworkSpec::Kind::kCandidateScorer,
          .observation_size = 3 * num_actions,
          .num_actions = num_actions,
          .features = 3,
          .hidden = {8, 8},
          .layer_norm = true,
          .schema = "test"};
}

WeightSnapshot SnapshotOf(const NetworkSpec& spec, std::vector<float> values) {
  return {.version = 7, .architecture_hash = ArchitectureHash(spec), .values = std::move(values)};
}

/// A policy whose Q(s, ·) are these numbers whatever s.
QPolicy WithValues(std::vector<float> q) {
  const NetworkSpec spec = Linear(static_cast<int>(q.size()));
  std::vector<float> weights(q.size(), 0.0f);
  weights.insert(weights.end(), q.begin(), q.end());
  QPolicy policy(spec);
  REQUIRE(policy.Load(SnapshotOf(spec, weights)) == LoadResult::kLoaded);
  return policy;
}

int ActOn(QPolicy policy, const std::vector<std::uint8_t>& legal) {
  return policy.Act(std::vector<float>{0.0f}, legal);
}

TEST_CASE("The policy takes the best legal action and the lowest of equals") {
  CHECK(ActOn(WithValues({1, 5, 3}), {1, 1, 1}) == 1);
  CHECK(ActOn(WithValues({1, 5, 3}), {1, 0, 1}) == 2);
  CHECK(ActOn(WithValues({5, 5, 5}), {1, 1, 1}) == 0);
  CHECK(ActOn(WithValues({5, 4, 4}), {0, 1, 1}) == 1);
  CHECK(ActOn(WithValues({-9, 5, 5}), {1, 0, 0}) == 0);
}

TEST_CASE("The policy's action is the best of its network's values") {
  Rng rng(31);
  const NetworkSpec spec = Scorer(4);
  const QNetwork<float> network(spec);
  const auto weights = RandomVector<float>(rng, network.parameter_count());
  QPolicy sut(spec);
  REQUIRE(sut.Load(SnapshotOf(spec, weights)) == LoadResult::kLoaded);
  QNetwork<float>::Workspace workspace;
  std::vector<float> q(4);
  int not_first = 0;
  for (int i = 0; i < 100; ++i) {
    const auto observation = RandomVector<float>(rng, 12);
    const std::vector<std::uint8_t> legal{1, static_cast<std::uint8_t>(i % 2), 1, 1};
    network.Forward(weights, observation, legal, workspace, q);
    const auto best = std::max_element(q.begin(), q.end()) - q.begin();
    not_first += best != 0 ? 1 : 0;
    CHECK(sut.Act(observation, legal) == best);
  }
  CHECK(not_first > 10);
}

TEST_CASE("Weights load only where architecture and length agree and all are finite") {
  const NetworkSpec spec = Linear(2);
  QPolicy sut = WithValues({1, 2});
  WeightSnapshot other = SnapshotOf(Linear(3), {0, 0, 0, 9, 0, 0});
  CHECK(sut.Load(other) == LoadResult::kOtherArchitecture);
  CHECK(sut.Load(SnapshotOf(spec, {0, 0, 9})) == LoadResult::kOtherArchitecture);
  for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity()})
    CHECK(sut.Load(SnapshotOf(spec, {0, 0, 9, bad})) == LoadResult::kNotFinite);
  CHECK(sut.weights_version() == 7);
  CHECK(sut.Act(std::vector<float>{0.0f}, std::vector<std::uint8_t>{1, 1}) == 1);  // as before
}

TEST_CASE("A scorer's weights load for another number of actions") {
  Rng rng(32);
  const auto weights = RandomVector<float>(rng, ParameterCount(Scorer(2)));
  QPolicy sut(Scorer(6));
  CHECK(sut.Load(SnapshotOf(Scorer(2), weights)) == LoadResult::kLoaded);
}

PolicyFile SomePolicy() {
  Rng rng(33);
  PolicyFile policy{.spec = Scorer(2),
                    .training = {.map = "cumberland",
                                 .agents = 10,
                                 .speed_mps = 1.5,
                                 .algorithm = "dqn",
                                 .seed = 3,
                                 .reward = "hindsight",
                                 .discount_horizon_s = 51.25,
                                 .decisions = 200'000,
                                 .training_s = 90.5,
                                 .agi_s = 12.92,
                                 .agi_ci95_s = 0.03,
                                 .ronda_version = "0.1.0"},
                    .version = 180,
                    .updates = 18000,
                    .weights = {}};
  policy.weights = RandomVector<float>(rng, ParameterCount(policy.spec));
  return policy;
}

TEST_CASE("A policy file gives back what was written") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "policy";
  const PolicyFile policy = SomePolicy();
  WritePolicyFile(path, policy);
  CHECK(ReadPolicyFile(path) == policy);
}

TEST_CASE("A policy file with any byte changed or cut is refused") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "policy";
  WritePolicyFile(path, SomePolicy());
  std::ifstream file(path, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  const auto refused = [&](const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
    try {
      (void)ReadPolicyFile(path);
    } catch (const CheckpointError&) {
      return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    INFO("byte " << i);
    REQUIRE(refused(changed));
    REQUIRE(refused(whole.substr(0, i)));
  }
  CHECK_FALSE(refused(whole));
}

TEST_CASE("A payload with a sound checksum and any byte changed never does worse than a refusal") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "policy";
  WritePolicyFile(path, SomePolicy());
  const std::string payload = ReadCheckedFile(path, "RONDAPOL", kPolicyFormat).payload;
  std::size_t refused = 0;
  for (std::size_t i = 0; i < 200; ++i) {  // the archive's head, where lengths and sizes are
    for (const int flip : {0x01, 0x7F, 0xFF}) {
      std::string changed = payload;
      changed[i] = static_cast<char>(changed[i] ^ flip);
      WriteCheckedFile(path, "RONDAPOL", kPolicyFormat, changed);
      try {
        (void)ReadPolicyFile(path);
      } catch (const CheckpointError&) {
        ++refused;
      }
    }
  }
  CHECK(refused > 200);
}

TEST_CASE("A policy that contradicts itself is neither written nor read") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "policy";
  const auto refused = [&](const auto& spoil, const std::string& words) {
    PolicyFile policy = SomePolicy();
    spoil(policy);
    CHECK_THROWS_AS(WritePolicyFile(path, policy), CheckpointError);
    CHECK_THROWS_WITH(WritePolicyFile(path, policy), Contains(path.string()) && Contains(words));
    CHECK_FALSE(std::filesystem::exists(path));
  };
  refused([](PolicyFile& p) { p.weights[3] = std::nanf(""); }, "weight 3 must be finite, got nan");
  refused([](PolicyFile& p) { p.weights.pop_back(); }, "weights, it holds");
  refused([](PolicyFile& p) { p.spec.hidden = {1 << 20, 1 << 20}; }, "at most");
  refused([](PolicyFile& p) { p.training.agents = -1; }, "agents must be ≥ 0, got -1");
  refused([](PolicyFile& p) { p.training.discount_horizon_s = -1.0; }, "discount_horizon_s");
  refused([](PolicyFile& p) { p.training.agi_s = std::nan(""); }, "agi_s must be finite");
  refused([](PolicyFile& p) { p.training.seed = -2; }, "seed must be");
  refused([](PolicyFile& p) { p.training.map = "a\33[2J"; }, "map must be at most");
  refused([](PolicyFile& p) { p.training.reward = std::string(1025, 'x'); }, "reward must be");
  refused([](PolicyFile& p) { p.spec.schema = "what is seen"; }, "schema");
}

TEST_CASE("A sound file whose numbers are no network's is refused") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "policy";
  const auto refused = [&](std::size_t at, const std::string& bytes, const std::string& words) {
    WritePolicyFile(path, SomePolicy());
    std::string payload = ReadCheckedFile(path, "RONDAPOL", kPolicyFormat).payload;
    payload.replace(at < payload.size() ? at : payload.size() - bytes.size(), bytes.size(), bytes);
    WriteCheckedFile(path, "RONDAPOL", kPolicyFormat, payload);
    CHECK_THROWS_WITH(ReadPolicyFile(path), Contains(path.string()) && Contains(words));
  };
  constexpr auto kLast = std::string::npos;
  refused(kLast, std::string("\0\0\xC0\x7F", 4), "must be finite, got nan");
  refused(1, std::string("\7\0\0\0", 4), "unknown kind 7");
  refused(13, std::string("\4\0\0\0", 4), "num_actions × features");  // features
  refused(25, std::string("\11\0\0\0", 4), "weights, it holds");      // a hidden layer's width
}

TEST_CASE("A file of format 1 is read, with the facts that it knows") {
  const PolicyFile sut = ReadPolicyFile(RONDA_SOURCE_DIR "/tests/golden/policy_format_1.ronda");
  CHECK(DescribeArchitecture(sut.spec) ==
        "scorer schema=patrol-candidates-26 features=26 hidden=6 layer_norm=1 activation=relu "
        "format=1");
  CHECK(sut.training == TrainingFacts{.map = "4nodes", .agents = 2, .algorithm = "dqn, seed 1"});
  CHECK(sut.format == 1);
  CHECK(sut.weights.size() == ParameterCount(sut.spec));
}

TEST_CASE("A file of format 2 is read, and written again with the same bytes") {
  const TemporaryFolder folder;
  const std::filesystem::path golden = RONDA_SOURCE_DIR "/tests/golden/policy_format_2.ronda";
  const PolicyFile sut = ReadPolicyFile(golden);
  CHECK(sut.training.map == "4nodes");
  CHECK(sut.training.reward == "hindsight");
  CHECK(sut.training.discount_horizon_s == 19.5);
  CHECK(sut.training.decisions == 6144);
  CHECK(sut.updates == 217);
  WritePolicyFile(folder / "again", sut);
  CHECK(ReadWholeFile(folder / "again") == ReadWholeFile(golden));
}

TEST_CASE("A checked file of another kind or a newer version is no policy") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "policy";
  WriteCheckedFile(path, "RONDACKP", 1, "x");
  CHECK_THROWS_WITH(ReadPolicyFile(path), Contains("not a RONDAPOL file"));
  WriteCheckedFile(path, "RONDAPOL", kPolicyFormat + 1, "x");
  CHECK_THROWS_WITH(ReadPolicyFile(path),
                    Contains(path.string() + ": written by a newer ronda: format 3, this one reads "
                                             "up to 2"));
  std::ofstream(path) << "[run]\nmap = \"cumberland\"\n";
  CHECK_THROWS_WITH(ReadPolicyFile(path), Contains(path.string() + ": not a RONDAPOL file"));
}

}  // namespace
}  // namespace ronda
