#include "deploy/cell_journal.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "common/base/error.h"

namespace ronda {
namespace {

using Json = nlohmann::ordered_json;

void CheckSameComparison(const Json& kept, const Json& wanted, const std::string& path) {
  for (const auto& [key, value] : wanted.items()) {
    const Json before = kept.value(key, Json());
    if (before == value) continue;
    throw UsageError(
        fmt::format("--out must be a new folder, or that of the same comparison; in {} '{}' was "
                    "{}, got {}",
                    path, key, before.dump(), value.dump()));
  }
}

std::vector<EpisodeResult> EpisodesOf(const Json& line) {
  std::vector<EpisodeResult> episodes;
  for (const Json& episode : line.at("episodes")) {
    episodes.push_back({.agi_s = episode.at(0).get<double>(),
                        .wi_s = episode.at(1).get<double>(),
                        .final_s = episode.at(2).get<double>(),
                        .decisions = episode.at(3).get<std::int64_t>()});
  }
  return episodes;
}

}  // namespace

CellJournal::CellJournal(const std::filesystem::path& path, const std::string& identity)
    : lines_(path, "finished cells") {
  std::ifstream file(path, std::ios::binary);
  bool begun = false;
  int number = 0;
  for (std::string text; std::getline(file, text);) {
    ++number;
    const Json line = Json::parse(text, nullptr, false);
    if (line.is_discarded()) continue;
    try {
      if (begun) {
        finished_.insert_or_assign(line.at("cell").get<std::size_t>(), EpisodesOf(line));
      } else {
        CheckSameComparison(line, Json::parse(identity), path.string());
        begun = true;
      }
    } catch (const Json::exception& error) {
      throw InputError(fmt::format("{}:{}: each line must be a finished cell of a comparison: {}",
                                   path.string(), number, error.what()));
    }
  }
  if (!begun) lines_.Append(identity);
}

std::optional<std::vector<EpisodeResult>> CellJournal::Find(std::size_t cell) const {
  const auto found = finished_.find(cell);
  return found == finished_.end() ? std::nullopt : std::optional(found->second);
}

void CellJournal::Append(std::size_t cell, const std::vector<EpisodeResult>& episodes) {
  Json line{{"cell", cell}, {"episodes", Json::array()}};
  for (const EpisodeResult& episode : episodes) {
    line["episodes"].push_back({episode.agi_s, episode.wi_s, episode.final_s, episode.decisions});
  }
  lines_.Append(line.dump());
  finished_.insert_or_assign(cell, episodes);
}

}  // namespace ronda
