#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "common/base/error.h"
#include "common/base/whole_file.h"
#include "common/run/duration.h"
#include "common/run/log.h"
#include "common/run/nearest_name.h"
#include "common/run/paths.h"
#include "common/run/restart_policy.h"
#include "tests/temporary_folder.h"

namespace ronda {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// The waits after deaths of lives that each lasted `life`; ends where it is given up.
std::vector<milliseconds> Waits(RestartPolicy sut, milliseconds life, int deaths) {
  std::vector<milliseconds> waits;
  RestartPolicy::TimePoint now{};
  for (int i = 0; i < deaths; ++i) {
    const auto next = sut.Died(now, now + life);
    if (!next) break;
    waits.push_back(std::chrono::duration_cast<milliseconds>(*next - (now + life)));
    now = *next;
  }
  return waits;
}

TEST_CASE("The fifth death without a healthy life gives up, after waits that double") {
  const std::vector<milliseconds> by_hand{milliseconds(100), milliseconds(200), milliseconds(400),
                                          milliseconds(800)};
  CHECK(Waits(RestartPolicy(), milliseconds(9'999), 99) == by_hand);
}

TEST_CASE("Lives of ten seconds are healthy and never give up") {
  CHECK(Waits(RestartPolicy(), seconds(10), 20) ==
        std::vector<milliseconds>(20, milliseconds(100)));
}

TEST_CASE("The wait grows to 5 s and no further") {
  const auto waits = Waits(RestartPolicy({.most_deaths = 100}), milliseconds(0), 9);
  const std::vector<milliseconds> by_hand{
      milliseconds(100),   milliseconds(200),   milliseconds(400),
      milliseconds(800),   milliseconds(1'600), milliseconds(3'200),
      milliseconds(5'000), milliseconds(5'000), milliseconds(5'000)};
  CHECK(waits == by_hand);
}

TEST_CASE("A healthy life forgets the deaths before it") {
  RestartPolicy sut;
  const RestartPolicy::TimePoint start{};
  for (int i = 0; i < 4; ++i) REQUIRE(sut.Died(start, start));
  CHECK(sut.Died(start, start + seconds(10)) == start + seconds(10) + milliseconds(100));
  CHECK(sut.deaths() == 1);
}

TEST_CASE("Durations are read in their units") {
  CHECK(ParseDuration("90s", "--for") == 90.0);
  CHECK(ParseDuration("2m", "--for") == 120.0);
  CHECK(ParseDuration("1.5h", "--for") == 5400.0);
  CHECK(ParseDuration("250ms", "--for") == Approx(0.25));
  CHECK(ParseDuration("7", "--for") == 7.0);
}

TEST_CASE("What is no duration above 0 is refused with option and value") {
  const char* text =
      GENERATE("", "s", "-1s", "0s", "1x", "nan", "inf", "1s2", "1 s", "1e3s", "0x2");
  CHECK_THROWS_AS(ParseDuration(text, "--for"), UsageError);
  CHECK_THROWS_WITH(ParseDuration("soon", "--for"),
                    "--for: must be a duration above 0, such as 90s, 2m, 1.5h or 250ms, got soon");
}

TEST_CASE("Durations are written for people") {
  CHECK(FormatDuration(0.0) == "0.0 s");
  CHECK(FormatDuration(0.44) == "0.4 s");
  CHECK(FormatDuration(9.97) == "10 s");
  CHECK(FormatDuration(85.4) == "85 s");
  CHECK(FormatDuration(200.0) == "3 min 20 s");
  CHECK(FormatDuration(7'170.0) == "119 min 30 s");
  CHECK(FormatDuration(7'500.0) == "2 h 5 min");
  CHECK(FormatDuration(10'799.0) == "3 h 0 min");
}

TEST_CASE("Edit distance counts inserted, deleted, replaced and swapped letters") {
  CHECK(EditDistance("", "abc") == 3);
  CHECK(EditDistance("abc", "") == 3);
  CHECK(EditDistance("kitten", "sitting") == 3);
  CHECK(EditDistance("batch_szie", "batch_size") == 1);
  CHECK(EditDistance("abc", "abc") == 0);
}

TEST_CASE("The nearest name is the first among equals, and none where none is known") {
  CHECK(NearestName("bat", {"cow", "cat", "rat"}) == "cat");
  CHECK_FALSE(NearestName("bat", {}));
  CHECK(NearestName("zoo.cat", {"zoo.rat", "cat"}) == "cat");
  CHECK(NearestName("cat", {"rat", "zoo.cat"}) == "zoo.cat");
}

TEST_CASE("RONDA_HOME moves the home folder, and without it the source folder is home") {
  ::setenv("RONDA_HOME", "/somewhere", 1);
  CHECK(MapsFolder() == "/somewhere/maps");
  CHECK(PoliciesFolder() == "/somewhere/policies");
  ::setenv("RONDA_HOME", "", 1);
  CHECK(HomeFolder() == RONDA_SOURCE_DIR);
  ::unsetenv("RONDA_HOME");
  CHECK(HomeFolder() == RONDA_SOURCE_DIR);
}

TEST_CASE("The program folder holds the running program") {
  CHECK(std::filesystem::exists(ProgramFolder() / "run_test"));
}

TEST_CASE("A log line has time, process, level and message") {
  const TemporaryFolder folder;
  StartLog("actor-3", folder / "log");
  LogWarning("{} of {} lost", 2, 7);
  CHECK(std::regex_match(ReadWholeFile(folder / "log"),
                         std::regex("\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d:\\d\\d\\.\\d{3} actor-3 "
                                    "warning: 2 of 7 lost\n")));
  StartLog("run_test");
}

TEST_CASE("A log file that cannot be written is an input error") {
  CHECK_THROWS_AS(StartLog("actor", "/dev/null/log"), InputError);
}

}  // namespace
}  // namespace ronda
