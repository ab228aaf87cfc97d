#pragma once
// Losses of one error e = prediction − target, with their slopes. Thread-safe; float and double.
//
// Squared: e² with slope 2e (thesis §2.4). Huber: e²/2 within ± δ, δ·(|e| − δ/2) outside; slope e
// clipped to ± δ (Huber 1964; Mnih et al. 2015).
namespace ronda {

enum class LossKind { kHuber, kSquared };

template <typename Scalar>
struct LossValue {
  Scalar value = 0;
  Scalar slope = 0;  // ∂value/∂prediction
};

/// `delta` > 0 is read by kHuber only. An error that is not finite gives a value that is not.
template <typename Scalar>
LossValue<Scalar> Loss(LossKind kind, Scalar error, Scalar delta);

}  // namespace ronda
