#include "common/nn/gemm_kernels.h"
#include "common/nn/gemm_tile.h"

namespace ronda::internal {

void MultiplyTileAvx512(const Product<float>& product) { MultiplyTiled<Vector64, 6, 4>(product); }

}  // namespace ronda::internal
