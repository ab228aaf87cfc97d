#include "deploy/live_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "deploy/figures.h"
#include "deploy/sparkline.h"
#include "deploy/text_table.h"

namespace ronda {
namespace {

using Lines = std::vector<StyledLine>;

constexpr std::size_t kFirstActors = 3;
constexpr std::size_t kMostProblems = 3;
constexpr int kWidestBar = 30;
constexpr int kWideScreen = 110;  // columns; below, tables leave room for who waits and what failed

template <typename Count>
std::string Plural(Count count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

bool IsActor(const ProcessStatus& process) { return process.role == "actor"; }

/// The first word of what it says of itself: "running", "waiting", "dead".
std::string Mood(const ProcessStatus& process) {
  return process.state.substr(0, process.state.find_first_of(" ,"));
}

Colour ColourOf(const std::string& mood) {
  if (mood == "running" || mood == "finished") return Colour::kGreen;
  return mood == "dead" || mood == "failed" ? Colour::kRed : Colour::kYellow;
}

/// 0: gone; 1: silent; 2: has died before; 3: nothing to say.
int Trouble(const ProcessStatus& process) {
  if (process.pid == 0 || Mood(process) == "dead") return 0;
  if (process.silent_s > kSilentAfterS) return 1;
  return process.last_error.empty() ? 3 : 2;
}

StyledLine Title(const RunStatus& status) {
  StyledLine line(status.state, ColourOf(status.state));
  if (status.exit_status.value_or(0) != 0) {
    line.Add(fmt::format(" (exit status {})", *status.exit_status));
  }
  line.Add(" · ").Add(status.map, Colour::kBold);
  line.Add(fmt::format(" · {} · {}", Plural(status.agents, "agent"), status.algorithm));
  return line.Add(fmt::format(" · pid {} · domain {}", status.launcher_pid, status.domain),
                  Colour::kDim);
}

StyledLine ProgressBar(const RunStatus& status, int columns) {
  const int width = std::clamp(columns / 5, 1, kWidestBar);
  const double share = status.progress > 0.0 ? std::min(status.progress, 1.0) : 0.0;
  const auto full = static_cast<int>(share * width);
  std::string done, rest;
  for (int i = 0; i < width; ++i) (i < full ? done : rest) += i < full ? "█" : "░";
  StyledLine line(Percent(status.progress) + " ", Colour::kBold);
  line.Add(done, Colour::kGreen).Add(rest, Colour::kDim);
  if (status.left_s) line.Add(fmt::format(" {} left ·", ShortDuration(*status.left_s)));
  return line.Add(fmt::format(" trained {} · {} decisions · {} updates",
                              ShortDuration(status.training_s),
                              Short(static_cast<double>(status.totals.decisions)),
                              Short(static_cast<double>(status.updates))));
}

StyledLine Rates(const RunStatus& status) {
  const auto count = [](std::uint64_t value) { return Short(static_cast<double>(value)); };
  const auto actors = std::count_if(
      status.processes.begin(), status.processes.end(),
      [](const ProcessStatus& process) { return IsActor(process) && process.pid != 0; });
  StyledLine line(fmt::format("{} of {} actors", actors, status.actors_wanted),
                  actors < status.actors_wanted ? Colour::kYellow : Colour::kNone);
  line.Add(fmt::format(" · {} decisions/s · {} updates/s · replay {} of {} · {} in flight",
                       Short(status.decisions_per_s), Short(status.updates_per_s),
                       count(status.replay_size), count(status.replay_capacity),
                       count(status.totals.in_flight)));
  if (status.totals.lost > 0) line.Add(fmt::format(" · {} lost", count(status.totals.lost)));
  if (status.totals.messages_refused > 0) {
    line.Add(fmt::format(" · {} messages refused", count(status.totals.messages_refused)),
             Colour::kYellow);
  }
  return line.Add(fmt::format(" · weights {}", status.totals.weights_version));
}

/// The curve and what its scale means; no curve before the first evaluation.
Lines Curve(const RunStatus& status, int columns) {
  std::vector<double> values;
  for (const CurvePoint& point : status.curve) {
    if (std::isfinite(point.agi_s)) values.push_back(point.agi_s);
  }
  const bool judged = !values.empty();
  const double now_s = judged ? values.back() : 0.0;
  const CurveMarks marks{.bound = status.lower_bound_agi_s,
                         .reference = status.best_classical_agi_s};
  StyledLine row("AGI ");
  for (const CurveBlock& block : Sparkline(std::move(values), marks, columns - row.columns())) {
    row.Add(BlockText(block), block.side == Side::kBelow      ? Colour::kGreen
                              : block.side == Side::kNotBelow ? Colour::kYellow
                                                              : Colour::kNone);
  }
  StyledLine legend(
      judged ? fmt::format("now {} s, best {}", Hundredths(now_s), Hundredths(status.best_agi_s))
             : std::string("AGI not judged yet"));
  if (status.best_classical_agi_s) {
    legend.Add(fmt::format(", best classical {} {}", status.best_classical,
                           Hundredths(status.best_classical_agi_s)));
  } else {
    legend.Add(", best classical not known yet");
  }
  if (status.lower_bound_agi_s) {
    legend.Add(fmt::format(", bound {}", Hundredths(status.lower_bound_agi_s)));
  }
  const std::string scale = " (▁ to ▄: better than classical)";
  if (judged && status.best_classical_agi_s &&
      legend.columns() + DisplayColumns(scale) <= columns) {
    legend.Add(scale, Colour::kDim);
  }
  return judged ? Lines{row, legend} : Lines{legend};
}

Lines Problems(const RunStatus& status) {
  Lines lines;
  const std::size_t all = status.problems.size();
  const std::size_t shown = all > kMostProblems ? kMostProblems - 1 : all;
  for (std::size_t i = 0; i < shown; ++i) {
    lines.emplace_back("! " + status.problems[i], Colour::kRed);
  }
  if (shown < all) {
    lines.emplace_back(fmt::format("… and {}", Plural(all - shown, "more problem")), Colour::kRed);
  }
  return lines;
}

TableRow ProcessRow(const ProcessStatus& process) {
  std::string rates;
  for (const auto& [what, per_s] : process.rates_per_s) {
    rates += fmt::format("{}{} {}/s", rates.empty() ? "" : ", ", Short(per_s), what);
  }
  std::string state = process.state;
  if (process.silent_s > kSilentAfterS && process.pid != 0) {
    state += fmt::format(", silent {}", ShortDuration(process.silent_s));
  }
  const Colour colour = Trouble(process) < 2 ? Colour::kRed : ColourOf(Mood(process));
  return {{ProcessName(process.role, process.index)},
          {process.pid == 0 ? "–" : std::to_string(process.pid)},
          {state, colour},
          {rates},
          {process.lag_versions ? Short(*process.lag_versions) : ""},
          {process.restarts == 0 ? "" : std::to_string(process.restarts)},
          {process.last_error, Colour::kRed}};
}

/// The heading and a line for each, in their order.
Lines ProcessTable(const std::vector<const ProcessStatus*>& processes, int columns) {
  if (processes.empty()) return {StyledLine("no process", Colour::kDim)};
  std::vector<TableRow> rows;
  for (const ProcessStatus* process : processes) rows.push_back(ProcessRow(*process));
  return TableLines({{.heading = "process"},
                     {.heading = "pid", .align = Align::kRight},
                     {.heading = "state", .widest = 30},
                     {.heading = "rates", .widest = columns < kWideScreen ? 18 : 40},
                     {.heading = "lag", .align = Align::kRight},
                     {.heading = "restarts", .align = Align::kRight},
                     {.heading = "last error"}},
                    rows);
}

Lines ChannelTable(const std::vector<ChannelStatus>& channels, int columns) {
  if (channels.empty()) return {};
  const int totals = columns < kWideScreen ? 0 : 20;  // left out, or as wide as they like
  std::vector<TableRow> rows;
  for (const ChannelStatus& channel : channels) {
    rows.push_back({{channel.topic},
                    {fmt::format("{} → {}", channel.from, channel.to)},
                    {Short(channel.messages_per_s)},
                    {ShortBytes(channel.bytes_per_s) + "/s"},
                    {Short(static_cast<double>(channel.messages))},
                    {ShortBytes(static_cast<double>(channel.bytes))},
                    {channel.waiting, Colour::kYellow}});
  }
  return TableLines({{.heading = "channel", .widest = 20},
                     {.heading = "from → to", .widest = 30},
                     {.heading = "messages/s", .align = Align::kRight},
                     {.heading = "bytes/s", .align = Align::kRight},
                     {.heading = "messages", .align = Align::kRight, .widest = totals},
                     {.heading = "bytes", .align = Align::kRight, .widest = totals},
                     {.heading = "waiting"}},
                    rows);
}

Lines Events(const std::vector<RunEvent>& events, int utc_offset_s) {
  Lines lines;
  for (const RunEvent& event : events) {
    lines.push_back(
        StyledLine(ClockTime(event.unix_s, utc_offset_s) + "  ", Colour::kDim).Add(event.text));
  }
  return lines;
}

/// "… and 12 more actors (11 running, 1 waiting)".
StyledLine HiddenActors(const std::vector<const ProcessStatus*>& hidden, bool some_shown) {
  std::map<std::string, std::size_t> moods;
  for (const ProcessStatus* process : hidden) ++moods[Mood(*process)];
  std::string text;
  for (const auto& [mood, count] : moods) {
    const std::string how_many = moods.size() == 1 ? "all" : std::to_string(count);
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", how_many, mood);
  }
  const std::string actors =
      some_shown ? "… and " + Plural(hidden.size(), "more actor") : Plural(hidden.size(), "actor");
  return StyledLine(fmt::format("{} ({})", actors, text), Colour::kDim);
}

/// How many lines of each part stand on the screen.
struct Parts {
  std::size_t top = 0;       // with heading and rows of the processes that are no actors
  std::size_t actors = 0;    // without the line about hidden ones
  std::size_t channels = 0;  // with the heading
  std::size_t events = 0;
  std::size_t gaps = 0;  // before processes, channels and events: 0 or 1 line each
  std::size_t all_actors = 0;

  std::size_t Height() const {
    return top + actors + (actors < all_actors ? 1 : 0) + channels + events +
           gaps * (1 + (channels > 0 ? 1 : 0) + (events > 0 ? 1 : 0));
  }
};

/// Takes away in the order of the header until what is left fits, or nothing more can go.
Parts Fit(Parts parts, std::size_t rows) {
  const auto shrink = [&](std::size_t& part, std::size_t least) {
    while (parts.Height() > rows && part > least) --part;
  };
  shrink(parts.events, 1);
  shrink(parts.actors, kFirstActors);
  shrink(parts.gaps, 0);
  shrink(parts.channels, 1);
  if (parts.channels == 1) parts.channels = 0;  // a heading alone
  shrink(parts.events, 0);
  shrink(parts.actors, 0);
  // What went later may have left more room than was needed.
  for (Parts more = parts; ++more.actors <= parts.all_actors;) {
    if (more.Height() <= rows) parts.actors = more.actors;
  }
  return parts;
}

}  // namespace

std::vector<std::string> RenderRunStatus(const RunStatus& status, const ViewSize& size,
                                         ViewStyle style, int utc_offset_s) {
  std::vector<const ProcessStatus*> actors, processes;
  for (const ProcessStatus& process : status.processes) {
    (IsActor(process) ? actors : processes).push_back(&process);
  }
  const std::size_t others = processes.size();

  Lines head{Title(status), ProgressBar(status, size.columns), Rates(status)};
  for (const Lines& more : {Curve(status, size.columns), Problems(status)}) {
    head.insert(head.end(), more.begin(), more.end());
  }
  const Lines channels = ChannelTable(status.channels, size.columns);
  const Lines events = Events(status.events, utc_offset_s);
  const auto rows = static_cast<std::size_t>(std::max(size.rows, 0));
  const Parts parts = Fit({.top = head.size() + 1 + others,
                           .actors = actors.size(),
                           .channels = channels.size(),
                           .events = events.size(),
                           .gaps = 1,
                           .all_actors = actors.size()},
                          rows);
  if (parts.actors < actors.size() || parts.Height() > rows) {
    std::stable_sort(actors.begin(), actors.end(),
                     [](const auto* a, const auto* b) { return Trouble(*a) < Trouble(*b); });
  }
  processes.insert(processes.end(), actors.begin(), actors.end());
  const Lines table = ProcessTable(processes, size.columns);

  Lines lines = head;
  const auto append = [&](auto begin, std::size_t count) {
    lines.insert(lines.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  lines.resize(lines.size() + parts.gaps);
  append(table.begin(), 1 + others + parts.actors);
  if (parts.actors < actors.size()) {
    actors.erase(actors.begin(), actors.begin() + static_cast<std::ptrdiff_t>(parts.actors));
    lines.push_back(HiddenActors(actors, parts.actors > 0));
  }
  if (parts.channels > 0) lines.resize(lines.size() + parts.gaps);
  append(channels.begin(), parts.channels);
  if (parts.events > 0) lines.resize(lines.size() + parts.gaps);
  append(events.end() - static_cast<std::ptrdiff_t>(parts.events), parts.events);

  lines.resize(std::min(lines.size(), rows));
  std::vector<std::string> drawn;
  for (const StyledLine& line : lines) drawn.push_back(line.Draw(size.columns, style));
  return drawn;
}

}  // namespace ronda
