#include "deploy/screen.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <optional>

#include "tests/unit/test_terminal.h"

namespace ronda {
namespace {

using Lines = std::vector<std::string>;

/// A variable of the environment for the time of a test.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* former = std::getenv(name)) former_ = former;
    Set(value);
  }
  ~Variable() { Set(former_ ? former_->c_str() : nullptr); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

  void Set(const char* value) {
    if (value == nullptr) {
      ::unsetenv(name_);
    } else {
      ::setenv(name_, value, 1);
    }
  }

 private:
  const char* name_;
  std::optional<std::string> former_;
};

TEST_CASE("A screen is active on a terminal only, if wanted, and not on a dumb one") {
  TestTerminal terminal(40, 10);
  Variable term("TERM", "xterm");
  CHECK(Screen(true, terminal.output()).active());
  CHECK_FALSE(Screen(false, terminal.output()).active());
  int pipe_ends[2];
  REQUIRE(::pipe(pipe_ends) == 0);
  const FileDescriptor reading(pipe_ends[0]), writing(pipe_ends[1]);
  CHECK_FALSE(Screen(true, writing.number()).active());
  for (const char* without : {"dumb", "", static_cast<const char*>(nullptr)}) {
    term.Set(without);
    CHECK_FALSE(Screen(true, terminal.output()).active());
  }
}

TEST_CASE("A screen that is not active writes nothing") {
  TestTerminal terminal(40, 10);
  const Variable term("TERM", "dumb");
  {
    Screen sut(true, terminal.output());
    sut.Draw({"one"});
    sut.Print("two");
    sut.Finish();
  }
  CHECK(terminal.bytes().empty());
}

TEST_CASE("The room for a picture follows the terminal's size") {
  TestTerminal terminal(40, 10);
  const Variable term("TERM", "xterm");
  const Screen sut(true, terminal.output());
  CHECK(sut.size().columns == 39);
  CHECK(sut.size().rows == 9);
  terminal.Resize(100, 30);
  CHECK(sut.size().columns == 99);
  CHECK(sut.size().rows == 29);
}

TEST_CASE("A terminal that does not know its size counts as 80 by 24") {
  TestTerminal terminal(0, 0);
  const Variable term("TERM", "xterm");
  const Screen sut(true, terminal.output());
  CHECK(sut.size().columns == 79);
  CHECK(sut.size().rows == 23);
}

TEST_CASE("Each picture stands in the place of the last, be it higher or lower") {
  TestTerminal terminal(40, 10);
  const Variable term("TERM", "xterm");
  Screen sut(true, terminal.output());
  sut.Draw({"first", "second, longer", "third"});
  CHECK(terminal.Lines() == Lines{"first", "second, longer", "third"});
  sut.Draw({"1", "2"});
  CHECK(terminal.Lines() == Lines{"1", "2"});
  sut.Draw({"a", "", "c", "d"});
  CHECK(terminal.Lines() == Lines{"a", "", "c", "d"});
}

TEST_CASE("After a resize the next picture still stands in the place of the last") {
  TestTerminal terminal(40, 10);
  const Variable term("TERM", "xterm");
  Screen sut(true, terminal.output());
  sut.Print("permanent");
  sut.Draw({std::string(39, 'x'), "short", std::string(25, 'y')});
  terminal.Resize(20, 10);
  sut.Draw({"narrow", "picture"});
  CHECK(terminal.Lines() == Lines{"permanent", "narrow", "picture"});
  terminal.Resize(60, 6);
  sut.Draw({"wide again"});
  CHECK(terminal.Lines() == Lines{"permanent", "wide again"});
}

TEST_CASE("A picture that fills the screen scrolls nothing away when it is drawn again") {
  TestTerminal terminal(10, 4);
  const Variable term("TERM", "xterm");
  Screen sut(true, terminal.output());
  for (int i = 0; i < 3; ++i) {
    Lines lines(static_cast<std::size_t>(sut.size().rows),
                std::string(9, static_cast<char>('a' + i)));
    sut.Draw(lines);
    CHECK(terminal.Lines() == lines);
  }
}

TEST_CASE("Permanent lines stand above the picture, in order, folded where they are long") {
  TestTerminal terminal(10, 10);
  const Variable term("TERM", "xterm");
  Screen sut(true, terminal.output());
  sut.Print("early");
  sut.Draw({"picture 1", "line 2"});
  sut.Print("actor 3 has died\nsecond");
  CHECK(terminal.Lines() ==
        Lines{"early", "actor 3 ha", "s died", "second", "picture 1", "line 2"});
  sut.Draw({"picture 2"});
  CHECK(terminal.Lines() == Lines{"early", "actor 3 ha", "s died", "second", "picture 2"});
}

TEST_CASE("A permanent line cannot drive the terminal") {
  TestTerminal terminal(60, 10);
  const Variable term("TERM", "xterm");
  Screen sut(true, terminal.output());
  sut.Print("\x1b[31mred\x1b[2J\x07");
  CHECK(terminal.Lines() == Lines{"\uFFFD[31mred\uFFFD[2J\uFFFD"});
}

TEST_CASE("The end leaves the last picture standing, the cursor below it and to be seen") {
  TestTerminal terminal(40, 10);
  const Variable term("TERM", "xterm");
  {
    Screen sut(true, terminal.output());
    sut.Draw({"one", "two"});
    CHECK(terminal.cursor_hidden());
    sut.Finish();
    CHECK_FALSE(terminal.cursor_hidden());
    CHECK(terminal.cursor_row() == 2);
    sut.Draw({"next"});
    CHECK(terminal.Lines() == Lines{"one", "two", "next"});
  }
  CHECK_FALSE(terminal.cursor_hidden());
  CHECK(terminal.cursor_row() == 3);
}

TEST_CASE("A paused terminal costs pictures, not time, and no permanent line") {
  TestTerminal terminal(40, 10);
  const Variable term("TERM", "xterm");
  Screen sut(true, terminal.output());
  sut.Draw({"before"});
  terminal.Pause();
  sut.Draw({"never seen"});
  sut.Print("permanent");
  terminal.Continue();
  sut.Draw({"after"});
  CHECK(terminal.Lines() == Lines{"permanent", "after"});
  CHECK(terminal.bytes().find("never") == std::string::npos);
}

TEST_CASE("A terminal that is gone ends the drawing and nothing else") {
  TestTerminal terminal(40, 10);
  const Variable term("TERM", "xterm");
  Screen sut(true, terminal.output());
  sut.Draw({"before"});
  terminal.HangUp();
  sut.Draw({"after"});
  CHECK_FALSE(sut.active());
}

TEST_CASE("NO_COLOR that is not empty makes the style plain") {
  Variable no_colour("NO_COLOR", nullptr);
  CHECK(TerminalStyle() == ViewStyle::kColour);
  no_colour.Set("");
  CHECK(TerminalStyle() == ViewStyle::kColour);
  no_colour.Set("1");
  CHECK(TerminalStyle() == ViewStyle::kPlain);
  no_colour.Set("0");
  CHECK(TerminalStyle() == ViewStyle::kPlain);
}

TEST_CASE("Local time is ahead of UTC by what TZ says at that moment") {
  Variable zone("TZ", "UTC0");
  ::tzset();
  CHECK(UtcOffset(1'700'000'000.0) == 0);
  zone.Set("CET-1CEST,M3.5.0,M10.5.0/3");
  ::tzset();
  CHECK(UtcOffset(1'700'000'000.0) == 3600);  // November
  CHECK(UtcOffset(1'690'000'000.0) == 7200);  // July
}

}  // namespace
}  // namespace ronda
