#include "actor/exploration.h"

#include <algorithm>
#include <cmath>

namespace ronda {

double Epsilon(const ExplorationConfig& config, double progress, std::uint32_t index,
               std::uint32_t actors) {
  double epsilon = config.end;
  if (config.schedule == ExplorationConfig::Schedule::kExponential) {
    epsilon = std::max(config.end, config.start * std::exp(-config.decay * progress));
  } else if (progress < config.share) {
    epsilon = config.start + (config.end - config.start) * progress / config.share;
  }
  if (config.ladder_alpha > 0.0 && actors > 1) {
    epsilon = std::pow(epsilon, 1.0 + config.ladder_alpha * index / (actors - 1.0));
  }
  return epsilon;
}

}  // namespace ronda
