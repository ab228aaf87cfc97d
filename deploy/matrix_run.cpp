#include "deploy/matrix_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "deploy/matrix_progress.h"

namespace ronda {
namespace {

struct Cell {
  const PlannedSetting* setting = nullptr;
  const PlannedContestant* contestant = nullptr;
  EvaluationReport report;    // its result comes last
  double episode_work = 0.0;  // as MatrixStatus counts it
};

/// In an episode.
double ExpectedDecisions(const PlannedSetting& setting) {
  const EvaluationMap& map = setting.map->map;
  const EvaluationOptions& options = setting.options;
  const EvaluationResult times = ProtocolTimes(map.context(), options);
  return (times.warmup_s + times.window_s) * TotalSpeed_mps(options.conditions, options.agents) /
         map.graph().mean_edge_length_m();
}

/// Of all settings, in the order of Matrix.
std::vector<Cell> MakeCells(const MatrixPlan& plan) {
  std::vector<Cell> cells;
  for (const PlannedSetting& setting : plan.settings) {
    const auto bounds = BoundsOf(setting.map->map.context(), setting.options);
    for (const PlannedContestant& contestant : plan.contestants) {
      cells.push_back({.setting = &setting,
                       .contestant = &contestant,
                       .report = {.map = setting.map->name,
                                  .contestant = contestant.contestant,
                                  .options = setting.options,
                                  .result = {},
                                  .bounds = bounds,
                                  .ratio_to_random = std::nullopt},
                       .episode_work = ExpectedDecisions(setting)});
    }
  }
  return cells;
}

/// Plays the cells that are not done, and keeps and shows what comes.
class Player {
 public:
  Player(std::vector<Cell>& cells, CellJournal* journal) : cells_(cells), journal_(journal) {
    status_.cells = cells.size();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      auto kept = journal_ != nullptr ? journal_->Find(i) : std::nullopt;
      if (!kept) {
        Queue(i);
        continue;
      }
      const PlannedSetting& setting = *cells_[i].setting;
      EvaluationResult result = ProtocolTimes(setting.map->map.context(), setting.options);
      result.episodes = *std::move(kept);
      Finish(i, std::move(result));
    }
  }

  /// How many cells are done then.
  std::size_t Play(const std::stop_token& stop) {
    const EvaluationListener listener{
        .on_episode = [this](std::size_t i, const EpisodeResult&) { OnEpisode(i); },
        .on_result =
            [this](std::size_t i, EvaluationResult result) {
              if (journal_ != nullptr) journal_->Append(open_[i], result.episodes);
              Finish(open_[i], std::move(result));
            }};
    EvaluateAll(evaluations_, 0, listener, stop);
    progress_.End();
    return status_.cells_done;
  }

 private:
  void Queue(std::size_t i) {
    const Cell& cell = cells_[i];
    const PlannedContestant& contestant = *cell.contestant;
    const StrategyContext context = cell.setting->map->map.context();
    open_.push_back(i);
    evaluations_.push_back(
        {.context = context,
         .make_strategy = [&contestant, context] { return contestant.Make(context); },
         .options = cell.setting->options});
    status_.work += cell.episode_work * cell.setting->options.episodes;
  }

  void Finish(std::size_t i, EvaluationResult result) {
    cells_[i].report.result = std::move(result);
    ++status_.cells_done;
  }

  void OnEpisode(std::size_t i) {
    const Cell& cell = cells_[open_[i]];
    const int agents = cell.setting->options.agents;
    status_.work_done += cell.episode_work;
    status_.present = fmt::format("{}, {} robot{}: {}", PanelName(cell.report), agents,
                                  agents == 1 ? "" : "s", cell.report.contestant.name);
    progress_.Show(status_);
  }

  std::vector<Cell>& cells_;
  CellJournal* journal_;
  std::vector<std::size_t> open_;        // the cells that are played
  std::vector<Evaluation> evaluations_;  // of open_
  MatrixStatus status_;
  MatrixProgress progress_;
};

/// Thesis protocol: every report's ratio to the random walk, which is one of them.
void AddRatiosToRandom(Comparison& comparison) {
  if (comparison.front().options.protocol != Protocol::kThesis) return;
  const auto random =
      std::ranges::find(comparison, Contestant{.name = "random"}, &EvaluationReport::contestant);
  for (EvaluationReport& report : comparison) {
    report.ratio_to_random = RatioToRandom(random->result, report.result);
  }
}

Matrix MatrixOf(std::vector<Cell>& cells, const MatrixPlan& plan) {
  Matrix matrix;
  for (std::size_t begin = 0; begin < cells.size(); begin += plan.contestants.size()) {
    Comparison comparison;
    for (std::size_t i = 0; i < plan.contestants.size(); ++i) {
      comparison.push_back(std::move(cells[begin + i].report));
    }
    AddRatiosToRandom(comparison);
    comparison.resize(plan.shown);
    matrix.push_back(std::move(comparison));
  }
  return matrix;
}

}  // namespace

MatrixRun RunMatrix(const MatrixPlan& plan, CellJournal* journal, const std::stop_token& stop) {
  std::vector<Cell> cells = MakeCells(plan);
  MatrixRun run{.matrix = std::nullopt, .cells_done = Player(cells, journal).Play(stop)};
  if (run.cells_done == cells.size()) run.matrix = MatrixOf(cells, plan);
  return run;
}

}  // namespace ronda
