#pragma once
// How a team used each place of a map: what a picture of it shows.
//
// Measured from a trace over its window (warm-up left out), all episodes and robots together. The
// mean over vertices of `mean_idleness_s` is the evaluation's AGI where no vertex has a priority:
// idleness is not weighted here. (A stay that a failure or the end cuts is not in the trace; its
// vertex counts as left.) O(visits of one episode) memory. Errors as TraceReader.
#include <vector>

#include "common/evaluation/trace_reader.h"

namespace ronda {

struct MapUsage {
  std::vector<double> mean_idleness_s;      // (V) over time, exact
  std::vector<double> traversals_per_hour;  // (E) as graph.edges(), both directions
};

/// Reads `trace`, which is of `graph`, to its end. A traversal counts where it ends.
MapUsage MeasureUsage(TraceReader& trace, const PatrolGraph& graph);

}  // namespace ronda
