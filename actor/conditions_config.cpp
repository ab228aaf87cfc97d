#include "actor/conditions_config.h"

#include <fmt/format.h>

#include <optional>

#include "common/base/error.h"
#include "common/world/conditions_text.h"

namespace ronda {
namespace {

/// 0 means none.
std::optional<double> UnlessZero(double value) {
  return value > 0.0 ? std::optional(value) : std::nullopt;
}

}  // namespace

Conditions ReadConditions(Config& config, int robots) {
  constexpr double kFar = 1e9;
  Conditions conditions;
  const auto take_text = [&](const char* key, const char* option, const char* default_value,
                             const char* doc) {
    const std::string text = config.GetString(key, default_value, {}, doc);
    try {
      if (!text.empty()) SetCondition(conditions, option, text);
    } catch (const UsageError& error) {
      throw InputError(fmt::format("{}: {}", key, error.what()));
    }
  };
  take_text("conditions.speeds", "speed", "1", "m/s; \"1/0.5\": the robots take them in turn");
  conditions.travel_noise =
      config.GetDouble("conditions.noise", 0.0, 0.0, 2.0, "σ of the logarithm of travel times");
  Communication& communication = conditions.communication;
  const double loss =
      config.GetDouble("conditions.message_loss", -1.0, -1.0, 1.0,
                       "probability; −1: 0, or 1 where an observation radius is all there is");
  if (loss >= 0.0) communication.message_loss = loss;
  communication.message_range_m =
      UnlessZero(config.GetDouble("conditions.message_range_m", 0.0, 0.0, kFar, "0: unlimited"));
  communication.message_delay_s =
      config.GetDouble("conditions.message_delay_s", 0.0, 0.0, kFar, "until a message is heard");
  communication.observation_radius_m = UnlessZero(config.GetDouble(
      "conditions.observation_radius_m", 0.0, 0.0, kFar, "that a robot sees; 0: it only hears"));
  take_text("conditions.fail", "fail", "", "\"3@600/5@900\": robot 3 at 600 s, robot 5 at 900 s");
  take_text("conditions.join", "join", "", "as fail: robots that join, or are back");
  Attrition& attrition = conditions.attrition;
  attrition.mean_time_to_failure_s = UnlessZero(config.GetDouble(
      "conditions.mean_time_to_failure_s", 0.0, 0.0, kFar, "of each robot; 0: none fails"));
  attrition.repair_s = UnlessZero(config.GetDouble("conditions.repair_s", 0.0, 0.0, kFar,
                                                   "until it is back; 0: it stays away"));
  take_text("conditions.priorities", "priority", "",
            "\"12=5/7=3\": priorities of vertices, others 1; empty: the map's");
  conditions.stay_s = config.GetDouble("conditions.stay_s", 0.0, 0.0, kFar,
                                       "staying put is an action of so many seconds; 0: it is not");
  try {
    CheckConditions(conditions, robots);
  } catch (const UsageError& error) {
    throw InputError(fmt::format("conditions: {}", error.what()));
  }
  return conditions;
}

}  // namespace ronda
