#pragma once
// One session of a run: starts the cluster, looks after it until the budget is used or a signal
// comes, and sums up.
//
// Returns the exit status. Errors: Error as the parts throw. Use it on the main thread (children
// follow it).
#include <stop_token>

#include "common/run/run_folder.h"
#include "deploy/run_display.h"
#include "deploy/train_setup.h"

namespace ronda {

int RunTraining(const TrainSetup& setup, const RunFolder& folder, RunDisplay::Look look,
                std::stop_token stop);

}  // namespace ronda
