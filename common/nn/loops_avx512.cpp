#include "common/nn/loops_table.h"

namespace ronda {

constexpr Loops kLoopsAvx512 = TableWith(MultiplyTiled<Vector64, 6, 4>);

}  // namespace ronda
