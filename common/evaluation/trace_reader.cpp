#include "common/evaluation/trace_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <system_error>
#include <unordered_map>
#include <utility>
#include <vector>

#define CSV_IO_NO_THREAD
#include <libfccp/csv.h>

#include "common/base/error.h"

namespace ronda {
namespace {

template <typename Number>
std::optional<Number> NumberIn(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// `cumberland` of "maps/cumberland.json".
std::string NameOfMap(const std::string& map) { return std::filesystem::path(map).stem().string(); }

}  // namespace

/// The rows as values: what one line alone can have wrong.
class TraceReader::Rows {
 public:
  Rows(const std::filesystem::path& path, const PatrolGraph& graph)
      : path_(path.string()), file_(Opened(path)), csv_(path_, file_) {
    for (int v = 0; v < graph.vertex_count(); ++v) vertex_of_.emplace(graph.vertex_id(v), v);
  }

  [[noreturn]] void Fail(const std::string& rule, const std::string& got) const {
    throw InputError(fmt::format("{}:{}: {}, got {}", path_, line(), rule, got));
  }
  /// `text` comes from the file: shown short, and without what a terminal would obey.
  [[noreturn]] void FailQuoted(const std::string& rule, std::string_view text) const {
    constexpr std::size_t kMaxShown = 60;
    Fail(rule,
         fmt::format("{:?}{}", text.substr(0, kMaxShown), text.size() > kMaxShown ? "…" : ""));
  }

  std::string FirstLine() {
    const char* const line = csv_.next_line();
    return line != nullptr ? line : "";
  }

  void ReadHeader() {
    Guard([&] {
      csv_.read_header(io::ignore_no_column, "episode", "time_s", "robot", "vertex", "event");
      return true;
    });
  }

  std::optional<TraceEvent> Next() {
    std::array<char*, 5> fields{};
    auto& [episode, time, robot, vertex, kind] = fields;
    if (!Guard(
            [&] { return csv_.read_row(fields[0], fields[1], fields[2], fields[3], fields[4]); }))
      return std::nullopt;
    TraceEvent event{.episode = Integer("episode", episode),
                     .time_s = Seconds("time_s", time),
                     .robot = -1,
                     .vertex = -1,
                     .kind = Kind(kind)};
    if (event.kind == TraceEventKind::kEnd) return event;
    event.robot = Integer("robot", robot);
    if (event.kind == TraceEventKind::kFail) return event;
    const auto found = vertex_of_.find(vertex);
    if (found == vertex_of_.end()) FailQuoted("vertex must be an id of the map's vertices", vertex);
    event.vertex = found->second;
    return event;
  }

  double Seconds(const std::string& what, std::string_view text) const {
    const auto value = NumberIn<double>(text);
    if (!value || !std::isfinite(*value) || *value < 0.0) {
      FailQuoted(what + " must be a finite number of at least 0", text);
    }
    return *value;
  }

 private:
  static std::ifstream Opened(const std::filesystem::path& path) {
    std::error_code error;
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path, error)) {
      throw InputError(fmt::format("{}: a trace must be a file that can be read", path.string()));
    }
    file.seekg(-1, std::ios::end);
    if (file.get() != '\n') {
      throw InputError(
          fmt::format("{}: a trace must end with a line end; it was cut", path.string()));
    }
    file.seekg(0);
    return file;
  }

  /// What the library throws becomes a sentence with file and line.
  template <typename Read>
  bool Guard(const Read& read) const {
    try {
      return read();
    } catch (const io::error::base&) {
      throw InputError(fmt::format(
          "{}:{}: a line must have the fields episode,time_s,robot,vertex,event", path_, line()));
    }
  }

  unsigned line() const { return std::max(1u, csv_.get_file_line()); }

  int Integer(const std::string& what, std::string_view text) const {
    const auto value = NumberIn<int>(text);
    if (!value || *value < 0) FailQuoted(what + " must be an integer of at least 0", text);
    return *value;
  }

  TraceEventKind Kind(std::string_view text) const {
    if (text == "start") return TraceEventKind::kStart;
    if (text == "visit") return TraceEventKind::kVisit;
    if (text == "join") return TraceEventKind::kJoin;
    if (text == "fail") return TraceEventKind::kFail;
    if (text == "end") return TraceEventKind::kEnd;
    FailQuoted("event must be start, visit, join, fail or end", text);
  }

  std::string path_;
  std::ifstream file_;
  io::CSVReader<5, io::trim_chars<>, io::double_quote_escape<',', '"'>> csv_;
  std::unordered_map<std::string, int> vertex_of_;
};

TraceReader::TraceReader(const std::filesystem::path& path, const PatrolGraph& graph,
                         const std::string& map)
    : graph_(&graph), rows_(std::make_unique<Rows>(path, graph)) {
  CheckHeader(rows_->FirstLine(), graph, map);
  rows_->ReadHeader();
}

TraceReader::~TraceReader() = default;

void TraceReader::CheckHeader(const std::string& line, const PatrolGraph& graph,
                              const std::string& map) {
  constexpr std::string_view kWarmup = "# warmup_s=";
  constexpr std::string_view kWindow = " window_s=";
  constexpr std::string_view kMap = " map=";
  const std::size_t window = line.find(kWindow);
  const std::size_t name = line.find(kMap);
  if (!line.starts_with(kWarmup) || window == std::string::npos || name == std::string::npos ||
      window > name) {
    rows_->FailQuoted("a trace must begin with '# warmup_s=… window_s=… map=…'", line);
  }
  warmup_s_ = rows_->Seconds("warmup_s", line.substr(kWarmup.size(), window - kWarmup.size()));
  window_s_ = rows_->Seconds("window_s",
                             line.substr(window + kWindow.size(), name - window - kWindow.size()));
  if (window_s_ == 0.0) rows_->Fail("window_s must be positive", "0");
  const std::string of_trace = NameOfMap(line.substr(name + kMap.size()));
  if (of_trace != NameOfMap(map) && of_trace != graph.name()) {
    rows_->FailQuoted(fmt::format("the trace must be of the map '{}'", graph.name()), of_trace);
  }
}

std::optional<TraceEvent> TraceReader::Next() {
  std::optional<TraceEvent> event = rows_->Next();
  if (!event) {
    if (episode_ == 0 || !on_patrol_.empty()) {
      rows_->Fail(fmt::format("the end of episode {} must follow", episode_), "the file's end");
    }
    return std::nullopt;
  }
  if (event->episode != episode_) {
    rows_->Fail(fmt::format("episode must be {}", episode_), std::to_string(event->episode));
  }
  if (event->time_s < time_s_) {
    rows_->Fail(fmt::format("time_s must be at least the {} before it", time_s_),
                fmt::to_string(event->time_s));
  }
  time_s_ = event->time_s;
  switch (event->kind) {
    case TraceEventKind::kStart:
      CheckStart(*event);
      break;
    case TraceEventKind::kVisit:
      CheckVisit(*event);
      break;
    case TraceEventKind::kJoin:
      CheckJoin(*event);
      break;
    case TraceEventKind::kFail:
      CheckFail(*event);
      break;
    case TraceEventKind::kEnd:
      CheckEnd(*event);
      break;
  }
  return event;
}

void TraceReader::CheckStart(const TraceEvent& event) {
  if (has_started_ || event.time_s != 0.0) {
    rows_->Fail("a start must be at time 0, before all other events", fmt::to_string(event.time_s));
  }
  if (!on_patrol_.empty() && event.robot <= on_patrol_.rbegin()->first) {
    rows_->Fail(
        fmt::format("robot must be above {}, the last to start", on_patrol_.rbegin()->first),
        std::to_string(event.robot));
  }
  on_patrol_[event.robot] = {.vertex = event.vertex, .time_s = 0.0};
}

void TraceReader::CheckVisit(TraceEvent& event) {
  has_started_ = true;
  const auto robot = on_patrol_.find(event.robot);
  if (robot == on_patrol_.end()) {
    rows_->Fail("the robot of a visit must be on patrol", std::to_string(event.robot));
  }
  event.before = std::exchange(robot->second, {.vertex = event.vertex, .time_s = event.time_s});
  const int from = event.before.vertex;
  if (event.vertex != from && !std::ranges::binary_search(graph_->neighbours(from), event.vertex)) {
    rows_->FailQuoted(fmt::format("vertex must be '{}', where robot {} was, or a neighbour of it",
                                  graph_->vertex_id(from), event.robot),
                      graph_->vertex_id(event.vertex));
  }
}

void TraceReader::CheckJoin(const TraceEvent& event) {
  has_started_ = true;
  const LastSeen there{.vertex = event.vertex, .time_s = event.time_s};
  if (!on_patrol_.emplace(event.robot, there).second) {
    rows_->Fail("the robot of a join must not be on patrol", std::to_string(event.robot));
  }
}

void TraceReader::CheckFail(const TraceEvent& event) {
  has_started_ = true;
  if (on_patrol_.erase(event.robot) == 0 || on_patrol_.empty()) {
    rows_->Fail("the robot of a fail must be on patrol, and not the last one",
                std::to_string(event.robot));
  }
}

void TraceReader::CheckEnd(const TraceEvent& event) {
  constexpr double kRounding_s = 1e-6;
  if (on_patrol_.empty()) rows_->Fail("an episode must begin with starts", "its end");
  if (std::abs(event.time_s - warmup_s_ - window_s_) > kRounding_s) {
    rows_->Fail(fmt::format("the end must be at {} s, warm-up plus window", warmup_s_ + window_s_),
                fmt::to_string(event.time_s));
  }
  ++episode_;
  time_s_ = 0.0;
  on_patrol_.clear();
  has_started_ = false;
}

}  // namespace ronda
