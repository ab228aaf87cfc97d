#include "deploy/cell_journal.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/evaluation/report_json.h"
#include "common/nn/kernel.h"

namespace ronda {
namespace {

using Json = nlohmann::ordered_json;

std::string Text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

EvaluationResult ResultOf(const Json& line) {
  EvaluationResult result;
  line.at("t_ref_s").get_to(result.t_ref_s);
  line.at("warmup_s").get_to(result.warmup_s);
  line.at("window_s").get_to(result.window_s);
  for (const Json& episode : line.at("episodes")) {
    result.episodes.push_back({.agi_s = episode.at(0).get<double>(),
                               .wi_s = episode.at(1).get<double>(),
                               .final_s = episode.at(2).get<double>(),
                               .decisions = episode.at(3).get<std::int64_t>()});
  }
  if (result.episodes.size() != line.at("cell").at("episodes")) {
    throw Json::out_of_range::create(0, "episodes: not as many as the cell has", &line);
  }
  return result;
}

std::map<std::string, EvaluationResult> ReadFinished(const std::filesystem::path& path) {
  std::map<std::string, EvaluationResult> finished;
  std::ifstream file(path, std::ios::binary);
  int number = 0;
  for (std::string text; std::getline(file, text);) {
    ++number;
    const Json line = Json::parse(text, nullptr, false);
    if (line.is_discarded()) continue;
    try {
      if (line.at("results_version") != kResultsVersion) continue;
      finished.insert_or_assign(Text(line.at("cell")), ResultOf(line));
    } catch (const Json::exception& error) {
      throw InputError(fmt::format("{}:{}: each line must be a finished cell of a comparison: {}",
                                   path.string(), number, error.what()));
    }
  }
  return finished;
}

}  // namespace

std::string CellKey(const EvaluationReport& report, const CellInputs& inputs) {
  Json key = SettingAsJson(report);
  key["map"] = inputs.map_fingerprint;
  key["length"] = inputs.length;
  if (report.options.protocol == Protocol::kThesis) key["horizon_s"] = report.options.horizon_s;
  if (report.contestant.kind == ContestantKind::kPolicy) {
    key[KindName(report.contestant.kind)] = inputs.policy_fingerprint;
    key["kernel"] = NameOf(KernelInUse());
  }
  return Text(key);
}

CellJournal::CellJournal(const std::filesystem::path& path)
    : finished_(ReadFinished(path)), lines_(path, "finished cells") {}

std::optional<EvaluationResult> CellJournal::Find(const std::string& key) const {
  const auto found = finished_.find(key);
  return found == finished_.end() ? std::nullopt : std::optional(found->second);
}

void CellJournal::Append(const std::string& key, const EvaluationResult& result) {
  Json line{{"results_version", kResultsVersion},
            {"cell", Json::parse(key)},
            {"t_ref_s", result.t_ref_s},
            {"warmup_s", result.warmup_s},
            {"window_s", result.window_s}};
  auto& episodes = line["episodes"] = Json::array();
  for (const EpisodeResult& episode : result.episodes) {
    episodes.push_back({episode.agi_s, episode.wi_s, episode.final_s, episode.decisions});
  }
  lines_.Append(Text(line));
  finished_.insert_or_assign(key, result);
}

}  // namespace ronda
