#pragma once
// How many decisions a second an actor's thread makes with the per-candidate scorer 26-64-64-1.
#include <string>

namespace ronda::bench {

/// Prints the network alone, encoder + network, and the whole step of an actor, all greedy on
/// random weights. `slice_s` as MeasureInTurn.
void PrintDecisionFigures(const std::string& map, int robots, double slice_s, int rounds);

}  // namespace ronda::bench
