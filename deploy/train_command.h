#pragma once
// `ronda train`: a cluster on this machine that trains one policy.
#include <stop_token>

namespace CLI {
class App;
}

namespace ronda {

/// `exit_status` is set where the run ends by itself with another one than 0.
void AddTrainCommand(CLI::App& app, std::stop_token stop, int& exit_status);

}  // namespace ronda
