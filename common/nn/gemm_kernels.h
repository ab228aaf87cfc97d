#pragma once
// The tiled kernels that gemm.cpp chooses from, each compiled for one instruction set. Call one
// only on a CPU that has it.
#include "common/nn/gemm.h"

namespace ronda::internal {

void MultiplyTileBaseline(const Product<float>& product);
void MultiplyTileAvx2(const Product<float>& product);    // x86-64 only; AVX2 and FMA
void MultiplyTileAvx512(const Product<float>& product);  // x86-64 only; AVX-512F

}  // namespace ronda::internal
