#include "deploy/live_view.h"

#include <catch2/catch.hpp>
#include <limits>

#include "deploy/run_display.h"
#include "tests/unit/run_status_example.h"
#include "tests/unit/terminal_columns.h"

namespace ronda {
namespace {

std::string Joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string Plain(const RunStatus& status, const ViewSize& size) {
  return Joined(RenderRunStatus(status, size, ViewStyle::kPlain));
}

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Long, wide and hostile texts wherever the status has one.
RunStatus HostileStatus() {
  const std::string text =
      "\x1b[2J\x1b]0;title\x07 巡回ロボットは補充を待つ 🚓🚓 re\u0301seau \u202E\xFF\n\r\t" +
      std::string(250, 'x');
  RunStatus status = TroubledRunStatus(7);
  status.map = status.algorithm = status.best_classical = text;
  status.problems.assign(6, text);
  for (ProcessStatus& process : status.processes) {
    process.state = process.last_error = text;
    process.rates_per_s[text] = 1.0;
  }
  status.processes.back().role = text;
  for (ChannelStatus& channel : status.channels) {
    channel.topic = channel.from = channel.to = channel.waiting = text;
  }
  for (RunEvent& event : status.events) event.text = text;
  return status;
}

/// What a damaged file could say.
RunStatus SenselessStatus() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  RunStatus status = TroubledRunStatus();
  status.progress = status.training_s = status.decisions_per_s = status.updates_per_s = nan;
  status.left_s = -1.0;
  status.agents = -1;
  status.best_agi_s = status.best_classical_agi_s = status.lower_bound_agi_s = nan;
  status.curve = {{nan, nan}, {0.0, std::numeric_limits<double>::infinity()}};
  status.processes[0].lag_versions = status.processes[0].silent_s = 1e300;
  status.channels[0].bytes_per_s = -nan;
  status.events[0].unix_s = nan;
  return status;
}

void CheckFits(const RunStatus& status, const Utf8Locale& locale) {
  for (int columns = 1; columns <= 200; ++columns) {
    for (int rows = 1; rows <= 60; ++rows) {
      const auto lines = RenderRunStatus(status, {columns, rows}, ViewStyle::kPlain);
      bool fits = !lines.empty() && lines.size() <= static_cast<std::size_t>(rows);
      for (const std::string& line : lines) {
        const int width = locale.Columns(line);
        fits = fits && width >= 0 && width <= columns;
      }
      if (!fits) FAIL_CHECK(columns << "×" << rows << ":\n" << Joined(lines));
    }
  }
}

TEST_CASE("A picture is never wider or higher than the screen, whatever the texts") {
  const Utf8Locale locale;
  CheckFits(TroubledRunStatus(), locale);
  CheckFits(HostileStatus(), locale);
  CheckFits(RunStatus(), locale);
}

TEST_CASE("Colour takes no columns: without its sequences a picture is the plain one") {
  for (const RunStatus& status : {TroubledRunStatus(), HostileStatus()}) {
    for (const int columns : {20, 80, 133}) {
      std::string colour = Joined(RenderRunStatus(status, {columns, 40}, ViewStyle::kColour));
      for (std::size_t at = 0; (at = colour.find("\x1b[")) != std::string::npos;) {
        colour.erase(at, colour.find('m', at) + 1 - at);
      }
      CHECK(colour == Plain(status, {columns, 40}));
    }
  }
}

TEST_CASE("A plain picture has no escape byte, a coloured one no sequence but colours") {
  CHECK_FALSE(Has(Plain(HostileStatus(), {120, 60}), "\x1b"));

  const std::string colour =
      Joined(RenderRunStatus(HostileStatus(), {120, 60}, ViewStyle::kColour));
  REQUIRE(Has(colour, "\x1b"));
  for (std::size_t at = colour.find('\x1b'); at != std::string::npos;
       at = colour.find('\x1b', at + 1)) {
    const std::size_t end = colour.find_first_not_of("0123456789;", at + 2);
    CHECK((colour[at + 1] == '[' && colour[end] == 'm'));
  }
}

TEST_CASE("Every process, channel and event of a small run is named") {
  const RunStatus status = ExampleRunStatus();
  const std::string text = Plain(status, {100, 30});
  for (const char* name : {"replay ", "learner ", "actor 0", "actor 1", "actor 2", "actor 3"}) {
    CHECK(Has(text, std::string("\n") + name));
  }
  for (const ChannelStatus& channel : status.channels) CHECK(Has(text, "\n" + channel.topic + " "));
  for (const RunEvent& event : status.events) CHECK(Has(text, event.text));
}

TEST_CASE("The head says which run, how far, how fast and how well") {
  const std::string text = Plain(ExampleRunStatus(), {120, 30});
  CHECK(Has(text, "running · cumberland · 5 agents · dqn"));
  CHECK(Has(text, " 42 % ██████████░░░░░░░░░░░░░░ 3 min 27 s left · trained 2 min 30 s"));
  CHECK(Has(text, "21.0 k decisions/s · 310 updates/s · replay 100 k of 1.00 M"));
  CHECK(Has(text, "AGI ███▇▅▅▄▄▄▄\n"));
  CHECK(Has(text, "now 12.95 s, best 12.92, best classical gei:0.5 13.74, bound 9.97"));
}

TEST_CASE("Before the first evaluation the view says so") {
  RunStatus status = ExampleRunStatus();
  status.curve.clear();
  status.best_agi_s.reset();
  status.best_classical.clear();
  status.best_classical_agi_s.reset();
  CHECK(Has(Plain(status, {100, 30}), "AGI not judged yet, best classical not known yet"));
}

TEST_CASE("Trouble is told: why, who is gone, who waits for what") {
  const std::string text = Plain(TroubledRunStatus(), {160, 40});
  CHECK(Has(text, "! actor 3 is dead and starts again in 1.2 s"));
  CHECK(Has(text, "dead, starting again in 1.2 s"));
  CHECK(Has(text, "exit status 4: no replay answers"));
  CHECK(Has(text, "2 actors wait for room in the replay"));
  CHECK(Has(text, "3 of 4 actors"));
}

TEST_CASE("Ninety actors fit into 24 rows, those in trouble first, the others in a sum") {
  const auto lines = RenderRunStatus(TroubledRunStatus(90), {80, 24}, ViewStyle::kPlain);
  const std::string text = Joined(lines);
  CHECK(lines.size() <= 24);
  REQUIRE(Has(text, "\nactor 89 "));
  REQUIRE(Has(text, "\nactor 0 "));
  CHECK(text.find("\nactor 89 ") < text.find("\nactor 0 "));
  CHECK(Has(text, "… and 86 more actors (all running)"));
  CHECK(Has(text, "experience"));
}

TEST_CASE("The sum of hidden actors says how they are") {
  RunStatus status = ExampleRunStatus(20);
  status.processes[20].state = "waiting for room in the replay";
  status.processes[21].state = "waiting for room in the replay";
  CHECK(Has(Plain(status, {80, 12}), "more actors (15 running, 2 waiting)"));
}

TEST_CASE("A lower screen loses events first, then actors, then channels") {
  const RunStatus status = ExampleRunStatus(8);
  const auto has = [&](int rows, const std::string& part) {
    return Has(Plain(status, {100, rows}), part);
  };
  // 5 head, 11 processes, 6 channels, 6 events, 3 gaps.
  CHECK(has(31, "policy 10"));
  CHECK_FALSE(has(30, "policy 10"));
  CHECK(has(26, "actor 7"));
  CHECK(has(26, "policy 15"));
  CHECK_FALSE(has(25, "actor 7"));
  CHECK(has(25, "control"));
  CHECK(has(22, "control"));
  CHECK_FALSE(has(15, "control"));
  CHECK(has(12, "actor 0"));
  CHECK(has(10, "actor 0"));
}

TEST_CASE("A tiny screen says how the run is and how far") {
  const auto lines = RenderRunStatus(ExampleRunStatus(), {20, 3}, ViewStyle::kPlain);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0] == "running · cumberlan…");
  CHECK(Has(lines[1], " 42 % █"));
}

TEST_CASE("Events have the clock time of the offset") {
  const RunStatus status = ExampleRunStatus();  // the first event: 22:12:20 UTC
  CHECK(Has(Plain(status, {100, 40}), "22:12:20  policy 10"));
  CHECK(
      Has(Joined(RenderRunStatus(status, {100, 40}, ViewStyle::kPlain, 7200)), "00:12:20  policy"));
}

TEST_CASE("How a run has ended is the first word") {
  RunStatus status = ExampleRunStatus();
  status.state = "failed";
  status.exit_status = 4;
  CHECK(Plain(status, {100, 40}).starts_with("failed (exit status 4) · "));
}

TEST_CASE("Figures that make no sense are shown as none") {
  const std::string text = Plain(SenselessStatus(), {160, 40});
  CHECK(Has(text, "  0 % "));
  CHECK(Has(text, "– decisions/s"));
  CHECK_FALSE(Has(text, "nan"));
  CHECK_FALSE(Has(text, "inf"));
}

TEST_CASE("A run in one line begins with what matters most, and cannot drive a terminal") {
  CHECK(DescribeRun(ExampleRunStatus()) ==
        " 42 %  3 min 27 s left  AGI 12.95 s (best classical 13.74 s)  21.0 k decisions/s  "
        "310 updates/s  replay 100000/1000000  lag 2 versions");
  CHECK(Has(DescribeRun(TroubledRunStatus()), "left  actor 3 is dead and starts again"));
  CHECK_FALSE(Has(DescribeRun(HostileStatus()), "\x1b"));
}

}  // namespace
}  // namespace ronda
