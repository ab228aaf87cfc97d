#include "common/nn/gemm_kernels.h"
#include "common/nn/gemm_tile.h"

namespace ronda::internal {

void MultiplyTileBaseline(const Product<float>& product) { MultiplyTiled<Vector16, 4, 2>(product); }

}  // namespace ronda::internal
