#pragma once
// One session of a run: starts the cluster, looks after it until the budget is used or a signal
// comes, and sums up.
//
// Returns the exit status. Errors: Error as the parts throw. Use it on the main thread (children
// follow it).
#include <stop_token>

#include "common/run/run_folder.h"
#include "deploy/run_state.h"
#include "deploy/train_setup.h"

namespace ronda {

int RunTraining(const TrainSetup& setup, const RunFolder& folder, std::stop_token stop);

/// Share of the budget that is used: the larger of the two shares; 0 where there is no limit.
double Progress(const RunConfig& run, double training_s, std::uint64_t decisions);

}  // namespace ronda
