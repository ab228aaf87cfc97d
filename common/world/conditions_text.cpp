#include "common/world/conditions_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "common/base/check.h"
#include "common/base/error.h"

namespace ronda {
namespace {

template <class Number>
Number Parse(const char* condition, std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw UsageError(fmt::format("{}: must be a number, got '{}'", condition, text));
  }
  return number;
}

/// Calls `take` with each of the parts that "/" separates.
template <class Take>
void ForEachPart(std::string_view text, const Take& take) {
  while (true) {
    const std::size_t slash = text.find('/');
    take(text.substr(0, slash));
    if (slash == std::string_view::npos) return;
    text.remove_prefix(slash + 1);
  }
}

/// The two sides of the last `mark` in a part.
std::pair<std::string_view, std::string_view> Sides(const char* condition, const char* rule,
                                                    std::string_view part, char mark) {
  const std::size_t at = part.rfind(mark);
  if (at == std::string_view::npos || at == 0 || at + 1 == part.size()) {
    throw UsageError(fmt::format("{}: must be {}, got '{}'", condition, rule, part));
  }
  return {part.substr(0, at), part.substr(at + 1)};
}

void AddChanges(Conditions& conditions, const char* condition, std::string_view text, bool joins) {
  ForEachPart(text, [&](std::string_view part) {
    const auto [robot, time_s] = Sides(condition, "ROBOT@SECONDS", part, '@');
    conditions.attrition.changes.push_back({.time_s = Parse<double>(condition, time_s),
                                            .robot = Parse<int>(condition, robot),
                                            .joins = joins});
  });
}

void SetSpeeds(Conditions& conditions, const std::string& text) {
  conditions.speeds_mps.clear();
  ForEachPart(text, [&](std::string_view part) {
    conditions.speeds_mps.push_back(Parse<double>("speed", part));
  });
}

void SetPriorities(Conditions& conditions, const std::string& text) {
  ForEachPart(text, [&](std::string_view part) {
    const auto [vertex, priority] = Sides("priority", "VERTEX=PRIORITY", part, '=');
    conditions.priorities.emplace_back(vertex, Parse<double>("priority", priority));
  });
}

constexpr std::array kOptions = {
    ConditionOption{"speed", "m/s; 1/0.5: the robots take these in turn", SetSpeeds},
    ConditionOption{"noise", "σ of travel times: each takes length/speed · exp(σZ − σ²/2)",
                    [](Conditions& conditions, const std::string& text) {
                      conditions.travel_noise = Parse<double>("noise", text);
                    }},
    ConditionOption{"message-loss", "probability that another robot misses a message",
                    [](Conditions& conditions, const std::string& text) {
                      conditions.communication.message_loss = Parse<double>("message loss", text);
                    }},
    ConditionOption{"message-range", "metres that a message reaches",
                    [](Conditions& conditions, const std::string& text) {
                      conditions.communication.message_range_m =
                          Parse<double>("message range", text);
                    }},
    ConditionOption{"message-delay", "seconds until a message is heard",
                    [](Conditions& conditions, const std::string& text) {
                      conditions.communication.message_delay_s =
                          Parse<double>("message delay", text);
                    }},
    ConditionOption{"observation-radius",
                    "metres that a robot sees; without an option of messages it hears nothing",
                    [](Conditions& conditions, const std::string& text) {
                      conditions.communication.observation_radius_m =
                          Parse<double>("observation radius", text);
                    }},
    ConditionOption{"fail", "ROBOT@SECONDS/…: robots that fail, at times from the episode's start",
                    [](Conditions& conditions, const std::string& text) {
                      AddChanges(conditions, "fail", text, false);
                    }},
    ConditionOption{"join", "ROBOT@SECONDS/…: robots that join, or are back",
                    [](Conditions& conditions, const std::string& text) {
                      AddChanges(conditions, "join", text, true);
                    }},
    ConditionOption{"mean-time-to-failure", "seconds, of each robot (exponential)",
                    [](Conditions& conditions, const std::string& text) {
                      conditions.attrition.mean_time_to_failure_s =
                          Parse<double>("mean time to failure", text);
                    }},
    ConditionOption{"repair", "seconds until a robot that failed at random is back",
                    [](Conditions& conditions, const std::string& text) {
                      conditions.attrition.repair_s = Parse<double>("repair time", text);
                    }},
    ConditionOption{"priority",
                    "VERTEX=PRIORITY/…: how much a vertex's idleness counts, others 1; instead of "
                    "the map's",
                    SetPriorities},
    ConditionOption{"stay", "staying put is legal, for so many seconds at a time",
                    [](Conditions& conditions, const std::string& text) {
                      conditions.stay_s = Parse<double>("stay", text);
                    }},
};

}  // namespace

std::span<const ConditionOption> ConditionOptions() { return kOptions; }

void SetCondition(Conditions& conditions, const std::string& name, const std::string& text) {
  const auto* const option =
      std::ranges::find(kOptions, std::string_view(name),
                        [](const ConditionOption& o) { return std::string_view(o.name); });
  RONDA_CHECK(option != kOptions.end(), "no condition is called {}", name);
  if (text != "none") option->set(conditions, text);
}

}  // namespace ronda
