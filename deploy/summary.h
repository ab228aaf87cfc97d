#pragma once
// The end of a session in figures: printed, and written to summary.json for programs (keys: README,
// "Scripting").
#include <cstdint>
#include <optional>
#include <string>

#include "common/evaluation/statistics.h"
#include "common/run/run_config.h"
#include "deploy/run_state.h"
#include "deploy/training_evaluator.h"

namespace ronda {

/// Totals of the run folder over all its sessions.
struct RunSummary {
  RunState state;
  std::optional<Estimate>
      agi_s;  // of the best policy; nullopt where there is none, or no time to judge it
  std::optional<Yardstick> yardstick;
};

std::string SummaryAsJson(const RunSummary& summary, const RunConfig& run);
std::string FormatSummary(const RunSummary& summary, const RunConfig& run,
                          const std::string& run_folder);

}  // namespace ronda
