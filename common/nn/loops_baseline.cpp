#include "common/nn/loops_table.h"

namespace ronda {

constexpr Loops kLoopsBaseline = TableWith(MultiplyTiled<Vector16, 4, 2>);

}  // namespace ronda
