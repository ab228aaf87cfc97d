#pragma once
// The loops over floats that cost time, compiled once for each kernel of kernel.h.
//
// loops_<kernel>.cpp fills one table from gemm_tile.h and element_loops.h, where each loop is
// described. Call a table only on a CPU that has its instructions.
#include <cstddef>

#include "common/nn/element_loops.h"
#include "common/nn/gemm.h"

namespace ronda {

struct Loops {
  void (*multiply)(const Product<float>&);
  void (*relu_forward)(float* x, std::size_t size);
  void (*relu_backward)(const float* y, float* d, std::size_t size);
  void (*add_rows)(const float* x, int rows, int cols, float* sum);
  void (*layer_norm_forward)(const LayerNormRows<float>&);
  void (*layer_norm_backward)(const LayerNormSlopes<float>&);
  void (*adam_step)(const AdamStep<float>&);
  double (*sum_of_squares)(const float* x, std::size_t size);
  void (*scale)(float* x, std::size_t size, float factor);
  void (*approach)(float* x, const float* goal, std::size_t size, float share);
};

extern const Loops kLoopsBaseline;
extern const Loops kLoopsAvx2;    // x86-64 only
extern const Loops kLoopsAvx512;  // x86-64 only

/// Of the kernel in use. UsageError as KernelInUse.
const Loops& LoopsInUse();

}  // namespace ronda
