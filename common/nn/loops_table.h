#pragma once
// The table of loops.h, filled with what this very source compiles. Included by loops_<kernel>.cpp.
#include "common/nn/gemm_tile.h"
#include "common/nn/loops.h"

namespace ronda {
namespace {

/// `Multiply` is a tile of this kernel's shape.
constexpr Loops TableWith(void (*multiply)(const Product<float>&)) {
  return {.multiply = multiply,
          .relu_forward = ReluForwardLoop<float>,
          .relu_backward = ReluBackwardLoop<float>,
          .add_rows = AddRowsLoop<float>,
          .layer_norm_forward = LayerNormForwardLoop<float>,
          .layer_norm_backward = LayerNormBackwardLoop<float>,
          .adam_step = AdamStepLoop<float>,
          .sum_of_squares = SumOfSquaresLoop<float>,
          .scale = ScaleLoop<float>,
          .approach = ApproachLoop<float>};
}

}  // namespace
}  // namespace ronda
