#include "common/nn/loops_table.h"

namespace ronda {

constexpr Loops kLoopsAvx2 = TableWith(MultiplyTiled<Vector32, 6, 2>);

}  // namespace ronda
