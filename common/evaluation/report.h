#pragma once
// One evaluation with everything that names it: what a figure needs beside it to be compared.
//
// As text for people and as JSON for programs (keys: docs/evaluation.md). Pure functions.
#include <optional>
#include <string>

#include "common/evaluation/protocol.h"
#include "common/world/bounds.h"

namespace ronda {

enum class ContestantKind { kStrategy, kPolicy };

const char* KindName(ContestantKind kind);  // strategy | policy

/// Who is judged, as the user named it.
struct Contestant {
  ContestantKind kind = ContestantKind::kStrategy;
  std::string name;
  friend bool operator==(const Contestant&, const Contestant&) = default;
};

struct EvaluationReport {
  std::string map;  // as the user named it
  Contestant contestant;
  EvaluationOptions options;
  EvaluationResult result;
  std::optional<LowerBounds> bounds;
  /// Thesis protocol only: the random walk's mean final idleness over this one's.
  std::optional<double> ratio_to_random;
};

/// The lower bounds that stand beside an evaluation with these options. nullopt where robots are
/// repaired for ever: who is back visits its start without having driven there.
std::optional<LowerBounds> BoundsOf(const StrategyContext& context,
                                    const EvaluationOptions& options);

/// One JSON object, indented, without a line end.
std::string ReportAsJson(const EvaluationReport& report);

/// A few lines: setting, then AGI, WI and final idleness with 95 % intervals and the bounds.
std::string FormatReport(const EvaluationReport& report);

/// "cumberland, 10 robots at 1 m/s, noise 0.1".
std::string FormatTeam(const std::string& map, const EvaluationOptions& options);

/// The lines that a human-readable result opens with: map, team, conditions, protocol with its
/// window, episodes, seed.
std::string FormatSetting(const EvaluationReport& report);

/// When the printed bounds hold, or why there are none: the line that such a result ends with.
std::string FormatBoundsNote(const EvaluationReport& report);

/// With 2 decimals, below 1 s with 4.
std::string FormatSeconds(double seconds);

/// `12.34 ± 0.56`, or without the interval where there is none.
std::string FormatEstimate(const Estimate& estimate);

}  // namespace ronda
