#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "common/nn/activation.h"
#include "common/nn/adam.h"
#include "common/nn/layer_norm.h"
#include "common/nn/linear.h"
#include "common/nn/losses.h"
#include "tests/unit/each_kernel.h"
#include "tests/unit/gradient_check.h"

namespace ronda {
namespace {

using testing::LargestGradientError;
using testing::RandomVector;

constexpr double kTolerance = 1e-7;
constexpr int kBatch = 3;
constexpr int kInputs = 5;
constexpr int kOutputs = 4;

double Dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

TEST_CASE("Linear's gradients are those of central differences") {
  Rng rng(1);
  auto x = RandomVector(rng, kBatch * kInputs);
  auto w = RandomVector(rng, kInputs * kOutputs);
  auto b = RandomVector(rng, kOutputs);
  const auto dy = RandomVector(rng, kBatch * kOutputs);  // the loss is Σ dy·y
  const auto loss = [&] {
    std::vector<double> y(kBatch * kOutputs);
    LinearForward<double>({x.data(), kBatch, kInputs}, {w.data(), kInputs, kOutputs},
                          {b.data(), 1, kOutputs}, {y.data(), kBatch, kOutputs});
    return Dot(dy, y);
  };
  std::vector<double> dx(x.size(), 99.0), dw(w.size()), db(b.size());

  LinearBackward<double>({x.data(), kBatch, kInputs}, {w.data(), kInputs, kOutputs},
                         {dy.data(), kBatch, kOutputs},
                         {.w = {dw.data(), kInputs, kOutputs},
                          .b = {db.data(), 1, kOutputs},
                          .x = {dx.data(), kBatch, kInputs}});

  CHECK(LargestGradientError(loss, x, dx) < kTolerance);
  CHECK(LargestGradientError(loss, w, dw) < kTolerance);
  CHECK(LargestGradientError(loss, b, db) < kTolerance);
}

TEST_CASE("Linear adds to the gradients of its parameters") {
  const std::vector<double> x{2.0}, w{3.0}, dy{5.0};
  std::vector<double> dw{100.0}, db{1000.0};

  LinearBackward<double>({x.data(), 1, 1}, {w.data(), 1, 1}, {dy.data(), 1, 1},
                         {.w = {dw.data(), 1, 1}, .b = {db.data(), 1, 1}, .x = {}});

  CHECK(dw[0] == 110.0);
  CHECK(db[0] == 1005.0);
}

TEST_CASE("Relu keeps what is positive and passes the slope there only") {
  std::vector<double> x{-1.0, 0.0, 2.0};
  std::vector<double> d{10.0, 20.0, 30.0};

  ReluForward<double>({x.data(), 1, 3});
  ReluBackward<double>({x.data(), 1, 3}, {d.data(), 1, 3});

  CHECK(x == std::vector<double>{0.0, 0.0, 2.0});
  CHECK(d == std::vector<double>{0.0, 0.0, 30.0});
}

TEST_CASE("Relu lets what is not a number through, so that a loss shows it") {
  std::vector<float> x{std::numeric_limits<float>::quiet_NaN()};
  ReluForward<float>({x.data(), 1, 1});
  CHECK(std::isnan(x[0]));
}

TEST_CASE("LayerNorm leaves each row with mean 0 and variance 1 before gain and shift") {
  Rng rng(2);
  constexpr int kCols = 13;  // no multiple of the lanes of its sums
  auto x = RandomVector(rng, kBatch * kCols, 7.0);
  const std::vector<double> gain(kCols, 2.0), shift(kCols, 3.0);
  std::vector<double> inverse(kBatch), y(x.size());

  LayerNormForward<double>({gain.data(), 1, kCols}, {shift.data(), 1, kCols},
                           {x.data(), kBatch, kCols}, {inverse.data(), kBatch, 1},
                           {y.data(), kBatch, kCols});

  for (int r = 0; r < kBatch; ++r) {
    double mean = 0.0, square = 0.0;
    for (int c = 0; c < kCols; ++c) {
      const double value = (y[static_cast<std::size_t>(r * kCols + c)] - 3.0) / 2.0;
      mean += value / kCols;
      square += value * value / kCols;
    }
    CHECK(mean == Approx(0.0).margin(1e-12));
    CHECK(square == Approx(1.0).epsilon(1e-4));  // ε in the root
  }
}

TEST_CASE("LayerNorm's gradients are those of central differences") {
  Rng rng(3);
  constexpr int kCols = 13;
  auto x = RandomVector(rng, kBatch * kCols);
  auto gain = RandomVector(rng, kCols);
  auto shift = RandomVector(rng, kCols);
  const auto dy = RandomVector(rng, kBatch * kCols);
  std::vector<double> normalised, inverse(kBatch), y(x.size());
  const auto loss = [&] {
    normalised = x;
    LayerNormForward<double>({gain.data(), 1, kCols}, {shift.data(), 1, kCols},
                             {normalised.data(), kBatch, kCols}, {inverse.data(), kBatch, 1},
                             {y.data(), kBatch, kCols});
    return Dot(dy, y);
  };
  loss();
  auto d = dy;
  std::vector<double> dgain(kCols), dshift(kCols);

  LayerNormBackward<double>({gain.data(), 1, kCols}, {normalised.data(), kBatch, kCols},
                            {inverse.data(), kBatch, 1}, {d.data(), kBatch, kCols},
                            {.gain = {dgain.data(), 1, kCols}, .shift = {dshift.data(), 1, kCols}});

  CHECK(LargestGradientError(loss, x, d) < kTolerance);
  CHECK(LargestGradientError(loss, gain, dgain) < kTolerance);
  CHECK(LargestGradientError(loss, shift, dshift) < kTolerance);
}

TEST_CASE("Huber is quadratic within delta and linear outside") {
  const auto inside = Loss(LossKind::kHuber, -1.0, 2.0);
  CHECK(inside.value == 0.5);
  CHECK(inside.slope == -1.0);
  const auto edge = Loss(LossKind::kHuber, 2.0, 2.0);
  CHECK(edge.value == 2.0);
  CHECK(edge.slope == 2.0);
  const auto outside = Loss(LossKind::kHuber, -5.0, 2.0);
  CHECK(outside.value == 8.0);  // 2·(5 − 1)
  CHECK(outside.slope == -2.0);
}

TEST_CASE("The squared loss is e² with slope 2e") {
  const auto sut = Loss(LossKind::kSquared, -3.0, 1.0);
  CHECK(sut.value == 9.0);
  CHECK(sut.slope == -6.0);
}

TEST_CASE("The slope of a loss is that of central differences") {
  for (const LossKind kind : {LossKind::kHuber, LossKind::kSquared}) {
    for (const double at : {-3.0, -0.7, 0.2, 1.4, 6.0}) {
      std::vector<double> error{at};
      const std::vector<double> slope{Loss(kind, at, 1.1).slope};
      CHECK(LargestGradientError([&] { return Loss(kind, error[0], 1.1).value; }, error, slope) <
            kTolerance);
    }
  }
}

TEST_CASE("A loss of what is not a number is not a number") {
  const auto nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(std::isnan(Loss(LossKind::kHuber, nan, 2.0f).value));
  CHECK(std::isnan(Loss(LossKind::kSquared, nan, 2.0f).value));
}

TEST_CASE("Adam's first step is the learning rate against the gradient's sign") {
  std::vector<double> parameters{1.0, 1.0, 1.0};
  const std::vector<double> gradient{0.001, -40.0, 0.0};
  Adam<double> sut(3);

  sut.Step(gradient, 0.1, parameters);

  CHECK(parameters[0] == Approx(0.9).epsilon(1e-4));
  CHECK(parameters[1] == Approx(1.1).epsilon(1e-8));
  CHECK(parameters[2] == 1.0);
}

TEST_CASE("Adam with a state that was put back goes on with the same bits") {
  Rng rng(4);
  auto parameters = RandomVector<float>(rng, 50);
  Adam<float> first(50);
  first.Step(RandomVector<float>(rng, 50), 0.01, parameters);
  const auto gradient = RandomVector<float>(rng, 50);
  auto copy = parameters;
  Adam<float> second(50);
  second.set_state(first.state());

  first.Step(gradient, 0.01, parameters);
  second.Step(gradient, 0.01, copy);

  CHECK(parameters == copy);
  CHECK(second.state().steps == 2);
}

TEST_CASE("Adam's moments of a weight without gradient end at 0 and never become denormal") {
  testing::OnEachKernel([] {
    std::vector<float> parameters(20, 1.0f);
    Adam<float> sut(20);
    sut.Step(std::vector<float>(20, 1e-3f), 0.01, parameters);
    const std::vector<float> none(20, 0.0f);
    bool denormal = false;
    for (int i = 0; i < 2000; ++i) {
      sut.Step(none, 0.01, parameters);
      for (const auto* const moments : {&sut.state().m, &sut.state().v})
        for (const float value : *moments) denormal |= std::fpclassify(value) == FP_SUBNORMAL;
    }
    CHECK_FALSE(denormal);
    CHECK(sut.state().m == none);
  });
}

TEST_CASE("Clipping scales a long gradient to the norm and leaves a short one") {
  std::vector<float> gradient(12, 0.0f);
  gradient[1] = 3.0f;
  gradient[11] = -4.0f;

  CHECK(ClipGradientNorm<float>(10.0, gradient) == Approx(5.0));
  CHECK(gradient[1] == 3.0f);
  CHECK(ClipGradientNorm<float>(1.0, gradient) == Approx(5.0));
  CHECK(gradient[1] == Approx(0.6f));
  CHECK(gradient[11] == Approx(-0.8f));
}

TEST_CASE("The norm of a gradient that is not finite is not finite, and nothing is scaled") {
  std::vector<float> gradient{1.0f, std::numeric_limits<float>::infinity()};
  CHECK_FALSE(std::isfinite(ClipGradientNorm<float>(0.5, gradient)));
  CHECK(gradient[0] == 1.0f);
}

}  // namespace
}  // namespace ronda
