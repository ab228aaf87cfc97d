#include "common/nn/gemm_kernels.h"
#include "common/nn/gemm_tile.h"

namespace ronda::internal {

void MultiplyTileAvx2(const Product<float>& product) { MultiplyTiled<Vector32, 6, 2>(product); }

}  // namespace ronda::internal
