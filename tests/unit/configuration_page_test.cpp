// docs/configuration.md is what the getters of the processes say.
#include <catch2/catch.hpp>

#include "common/base/whole_file.h"
#include "deploy/config_command.h"
#include "deploy/train_setup.h"
#include "tests/expect_same_text.h"

namespace ronda {
namespace {

TEST_CASE("The first line that differs is shown") {
  CHECK(testing::FirstDifference("a\nb\n", "a\nb\n") == "");
  CHECK(testing::FirstDifference("a\nb\n", "a\nc\n") == "line 2\n  kept: c\n  now:  b");
  CHECK(testing::FirstDifference("a\n", "a\nc\n") == "line 2\n  kept: c\n  now:  (the text ends)");
  CHECK(testing::FirstDifference("a\n", "a") == "the last line's end differs");
}

TEST_CASE("docs/configuration.md is what `ronda config` prints") {
  testing::ExpectSameText(ConfigurationPage(),
                          ReadWholeFile(RONDA_SOURCE_DIR "/docs/configuration.md"),
                          "build/release/bin/ronda config > docs/configuration.md");
}

TEST_CASE("The configuration page names every key of a run's file, once") {
  TrainArguments arguments;
  arguments.map = RONDA_SOURCE_DIR "/maps/4nodes.json";
  const TrainSetup setup(arguments, std::nullopt);
  const std::string page = ConfigurationPage();

  REQUIRE(setup.config().known().size() > 30);
  for (const Config::Known& known : setup.config().known()) {
    CAPTURE(known.key);
    const std::string row = "\n| `" + known.key + "` |";
    REQUIRE(page.find(row) != std::string::npos);
    CHECK(page.find(row) == page.rfind(row));
  }
}

}  // namespace
}  // namespace ronda
