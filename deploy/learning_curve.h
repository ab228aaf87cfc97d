#pragma once
// The evaluations that a run's metrics.jsonl holds: how its policy became better.
#include <filesystem>
#include <vector>

#include "deploy/run_status.h"

namespace ronda {

/// Oldest first. Lines that are no evaluations are passed over, torn ones too; empty where there is
/// no file.
std::vector<CurvePoint> ReadLearningCurve(const std::filesystem::path& metrics_file);

}  // namespace ronda
