#pragma once
// Reports with figures by hand.
#include <vector>

#include "common/evaluation/report.h"

namespace ronda::testing {

/// A steady report whose episodes have these AGIs, WI ten times and final idleness twice as large.
inline EvaluationReport ReportOf(const Contestant& contestant, const std::vector<double>& agi_s) {
  EvaluationReport report{
      .map = "somewhere",
      .contestant = contestant,
      .options = {.episodes = static_cast<int>(agi_s.size()),
                  .seed = 9,
                  .agents = 3,
                  .conditions = {.speeds_mps = {2.0}, .travel_noise = 0.25}},
      .result = {.t_ref_s = 5.0, .warmup_s = 100.0, .window_s = 300.0, .episodes = {}},
      .bounds = LowerBounds{.agi_s = 2.0, .wi_s = 4.0},
      .ratio_to_random = std::nullopt};
  for (const double agi : agi_s) {
    report.result.episodes.push_back(
        {.agi_s = agi, .wi_s = 10.0 * agi, .final_s = 2.0 * agi, .decisions = 7});
  }
  return report;
}

}  // namespace ronda::testing
