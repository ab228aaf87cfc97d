#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/nn/adam.h"
#include "common/nn/losses.h"
#include "common/nn/mlp.h"
#include "common/nn/q_network.h"
#include "tests/unit/each_kernel.h"
#include "tests/unit/gradient_check.h"

namespace ronda {
namespace {

using testing::LargestGradientError;
using testing::RandomVector;

constexpr double kTolerance = 1e-7;

NetworkSpec Scorer(int num_actions, int features, bool layer_norm) {
  return {.kind = NetworkSpec::Kind::kCandidateScorer,
          .observation_size = num_actions * features,
          .num_actions = num_actions,
          .features = features,
          .hidden = {7, 6},
          .layer_norm = layer_norm,
          .schema = "test"};
}

NetworkSpec Perceptron(bool layer_norm) {
  return {.kind = NetworkSpec::Kind::kMlp,
          .observation_size = 5,
          .num_actions = 3,
          .hidden = {7, 6},
          .layer_norm = layer_norm,
          .schema = "test"};
}

using Golden = std::map<std::string, std::vector<double>>;

Golden ReadGolden() {
  std::ifstream file(RONDA_SOURCE_DIR "/tests/golden/layer_norm_mlp.txt");
  Golden golden;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    std::size_t count = 0;
    words >> name >> count;
    auto& values = golden[name];
    for (double value = 0.0; words >> value;) values.push_back(value);
    REQUIRE(values.size() == count);
  }
  REQUIRE(golden.size() == 12);
  return golden;
}

template <typename Scalar>
double LargestDifference(std::span<const Scalar> values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    largest = std::max(largest, std::abs(static_cast<double>(values[i]) - expected[i]));
  return largest;
}

template <typename Scalar>
std::vector<Scalar> As(const std::vector<double>& values) {
  std::vector<Scalar> result;
  for (const double value : values) result.push_back(static_cast<Scalar>(value));
  return result;
}

/// Forward, loss, gradient and three steps of Adam against the fixture.
template <typename Scalar>
void CheckAgainstGolden(double tolerance) {
  const Golden golden = ReadGolden();
  const auto sizes = As<int>(golden.at("sizes"));
  const Mlp<Scalar> sut({.inputs = sizes[0],
                         .hidden = {sizes[1], sizes[2]},
                         .outputs = sizes[3],
                         .layer_norm = true});
  const auto x = As<Scalar>(golden.at("x"));
  const auto target = As<Scalar>(golden.at("target"));
  auto parameters = As<Scalar>(golden.at("parameters"));
  const int batch = static_cast<int>(x.size()) / sizes[0];
  const auto delta = static_cast<Scalar>(golden.at("delta")[0]);
  Adam<Scalar> adam(parameters.size());
  typename Mlp<Scalar>::Workspace workspace;
  for (int step = 0; step < 3; ++step) {
    const auto y = sut.Forward(parameters, {x.data(), batch, sizes[0]}, workspace);
    std::vector<Scalar> dy(target.size());
    double loss = 0.0;
    for (std::size_t i = 0; i < target.size(); ++i) {
      const auto value = Loss(LossKind::kHuber, y.data[i] - target[i], delta);
      loss += static_cast<double>(value.value) / batch;
      dy[i] = value.slope / static_cast<Scalar>(batch);
    }
    if (step == 0) {
      CHECK(LargestDifference<Scalar>({y.data, y.size()}, golden.at("output")) < tolerance);
      CHECK(loss == Approx(golden.at("loss")[0]).margin(tolerance));
    }
    std::vector<Scalar> gradient(parameters.size());
    sut.Backward(parameters, {x.data(), batch, sizes[0]}, {dy.data(), batch, sizes[3]}, workspace,
                 gradient);
    if (step == 0) CHECK(LargestDifference<Scalar>(gradient, golden.at("gradient")) < tolerance);
    adam.Step(gradient, golden.at("learning_rate")[0], parameters);
    CHECK(LargestDifference<Scalar>(
              parameters, golden.at("parameters_after_" + std::to_string(step + 1))) < tolerance);
  }
}

TEST_CASE("A perceptron with LayerNorm and Adam in double give an independent program's numbers") {
  CheckAgainstGolden<double>(1e-10);
}

TEST_CASE("A perceptron with LayerNorm and Adam in float give an independent program's numbers") {
  testing::OnEachKernel([] { CheckAgainstGolden<float>(2e-5); });
}

TEST_CASE("A perceptron starts with He's deviation, a small last layer, no bias and unit gain") {
  const Mlp<double> sut({.inputs = 200, .hidden = {300}, .outputs = 100, .layer_norm = true});
  std::vector<double> parameters(sut.layout().size());
  Rng rng(5);

  sut.Initialise(rng, parameters);

  const auto deviation = [&](std::size_t block) {
    const auto& place = sut.layout().blocks()[block];
    double square = 0.0;
    for (std::size_t i = 0; i < place.size(); ++i)
      square += parameters[place.offset + i] * parameters[place.offset + i];
    return std::sqrt(square / static_cast<double>(place.size()));
  };
  // 60 000 and 30 000 normal draws: the deviation's own error is below 0.5 %, so 3 % is 7 sigma
  CHECK(deviation(0) == Approx(std::sqrt(2.0 / 200)).epsilon(0.03));
  CHECK(deviation(4) == Approx(0.1 * std::sqrt(1.0 / 300)).epsilon(0.03));
  CHECK(deviation(1) == 0.0);
  CHECK(deviation(2) == 1.0);
  CHECK(deviation(3) == 0.0);
}

/// The gradient of Σ dq·Q(chosen) of a network, against central differences.
double ChosenGradientError(const NetworkSpec& spec) {
  Rng rng(6);
  const QNetwork<double> sut(spec);
  auto parameters = RandomVector(rng, sut.parameter_count(), 0.7);
  const std::vector<std::int32_t> actions{2, 0, QNetwork<double>::kNoAction, 1};
  const auto observations =
      RandomVector(rng, actions.size() * static_cast<std::size_t>(spec.observation_size));
  const auto dq = RandomVector(rng, actions.size());
  QNetwork<double>::Workspace workspace;
  std::vector<double> q(actions.size());
  const auto loss = [&] {
    sut.ForwardChosen(parameters, observations, actions, workspace, q);
    double sum = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) sum += dq[i] * q[i];
    return sum;
  };
  loss();
  CHECK(q[2] == 0.0);
  std::vector<double> gradient(parameters.size());
  sut.BackwardChosen(parameters, actions, dq, workspace, gradient);
  return LargestGradientError(loss, parameters, gradient);
}

TEST_CASE("The gradient of chosen actions is that of central differences") {
  CHECK(ChosenGradientError(Scorer(3, 5, false)) < kTolerance);
  CHECK(ChosenGradientError(Scorer(3, 5, true)) < kTolerance);
  CHECK(ChosenGradientError(Perceptron(false)) < kTolerance);
  CHECK(ChosenGradientError(Perceptron(true)) < kTolerance);
}

TEST_CASE("The values of chosen actions are those among all values") {
  for (const NetworkSpec& spec : {Scorer(3, 5, true), Perceptron(true)}) {
    Rng rng(7);
    const QNetwork<float> sut(spec);
    const auto parameters = RandomVector<float>(rng, sut.parameter_count());
    const auto observations =
        RandomVector<float>(rng, 3 * static_cast<std::size_t>(spec.observation_size));
    const std::vector<std::uint8_t> legal{1, 0, 1, 0, 0, 0, 1, 1, 1};
    const std::vector<std::int32_t> actions{2, QNetwork<float>::kNoAction, 1};
    QNetwork<float>::Workspace workspace;
    std::vector<float> q(9), chosen(3);

    sut.Forward(parameters, observations, legal, workspace, q);
    sut.ForwardChosen(parameters, observations, actions, workspace, chosen);

    for (std::size_t i = 0; i < q.size(); ++i)
      CHECK((legal[i] != 0 ? std::isfinite(q[i]) : q[i] == QNetwork<float>::kIllegal));
    CHECK(chosen == std::vector<float>{q[2], 0.0f, q[7]});
  }
}

TEST_CASE("A scorer gives a candidate the same value whatever its place and company") {
  Rng rng(8);
  const QNetwork<float> three(Scorer(3, 5, true)), one(Scorer(1, 5, true));
  const auto parameters = RandomVector<float>(rng, three.parameter_count());
  const auto observation = RandomVector<float>(rng, 15);
  QNetwork<float>::Workspace workspace;
  std::vector<float> q(3), alone(1);

  three.Forward(parameters, observation, std::vector<std::uint8_t>{1, 1, 1}, workspace, q);

  for (std::size_t a = 0; a < 3; ++a) {
    one.Forward(parameters, std::span(observation).subspan(5 * a, 5), std::vector<std::uint8_t>{1},
                workspace, alone);
    CHECK(alone[0] == q[a]);
  }
}

TEST_CASE("A scorer never reads the features of an illegal candidate") {
  Rng rng(9);
  const QNetwork<float> sut(Scorer(2, 3, false));
  const auto parameters = RandomVector<float>(rng, sut.parameter_count());
  auto observation = RandomVector<float>(rng, 6);
  for (std::size_t i = 0; i < 3; ++i) observation[i] = std::nanf("");
  QNetwork<float>::Workspace workspace;
  std::vector<float> q(2);

  sut.Forward(parameters, observation, std::vector<std::uint8_t>{0, 1}, workspace, q);

  CHECK(std::isfinite(q[1]));
}

TEST_CASE("A scorer's hash says nothing of the number of actions, a perceptron's does") {
  CHECK(ArchitectureHash(Scorer(3, 5, true)) == ArchitectureHash(Scorer(8, 5, true)));
  NetworkSpec more_actions = Perceptron(true);
  more_actions.num_actions = 4;
  CHECK(ArchitectureHash(more_actions) != ArchitectureHash(Perceptron(true)));
}

TEST_CASE("Everything that changes what weights mean changes the hash") {
  const NetworkSpec base = Scorer(3, 5, true);
  std::vector<NetworkSpec> others(5, base);
  others[0].schema = "test2";
  others[1].layer_norm = false;
  others[2].hidden = {6, 7};
  others[3] = Scorer(3, 6, true);
  others[4].kind = NetworkSpec::Kind::kMlp;
  for (const NetworkSpec& other : others) CHECK(ArchitectureHash(other) != ArchitectureHash(base));
}

TEST_CASE("An architecture's hash is the same on every machine and in every release") {
  CHECK(DescribeArchitecture(Scorer(3, 5, true)) ==
        "scorer schema=test features=5 hidden=7,6 layer_norm=1 activation=relu format=1");
  CHECK(ArchitectureHash(Scorer(3, 5, true)) == 0xf8b5a8e6e8919149ull);
}

TEST_CASE("The parameter count foretold is the layout's") {
  for (const NetworkSpec& spec : {Scorer(3, 5, true), Scorer(2, 9, false), Perceptron(true)})
    CHECK(ParameterCount(spec) == QNetwork<float>(spec).parameter_count());
}

TEST_CASE("A network that cannot be is refused with rule and value") {
  const auto refused = [](NetworkSpec spec, const std::string& words) {
    CHECK_THROWS_WITH(CheckNetworkSpec(spec), Catch::Matchers::Contains(words));
    CHECK_THROWS_AS(QNetwork<float>(spec), InputError);
  };
  NetworkSpec spec = Scorer(3, 5, true);
  spec.observation_size = 16;
  refused(spec, "3 × 5, got 16");
  spec = Perceptron(true);
  spec.hidden = {0};
  refused(spec, "width must be 1 to 1048576, got 0");
  spec.hidden = {1 << 20, 1 << 20};
  refused(spec, "at most 67108864 parameters");
  spec = Perceptron(true);
  spec.schema = "a b";
  refused(spec, "schema");
  spec.schema = "";
  refused(spec, "schema");
}

}  // namespace
}  // namespace ronda
