#include "bench/sgemm.h"

#ifdef RONDA_HAS_OPENBLAS
#include <cblas.h>

#include <vector>
#endif

namespace ronda::bench {

Sgemm MakeSgemm() {
#ifdef RONDA_HAS_OPENBLAS
  openblas_set_num_threads(1);
  constexpr int kSize = 1024;
  const std::vector<float> ones(std::size_t{kSize} * kSize, 1.0f);
  return {.name = std::string(openblas_get_config()) + ", one thread",
          .call = [a = ones, b = ones, c = ones]() mutable {
            cblas_sgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, kSize, kSize, kSize, 1.0f,
                        a.data(), kSize, b.data(), kSize, 0.0f, c.data(), kSize);
          }};
#else
  return {.name = "missing (package libopenblas-dev)", .call = nullptr};
#endif
}

}  // namespace ronda::bench
