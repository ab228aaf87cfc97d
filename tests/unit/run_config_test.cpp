#include <catch2/catch.hpp>
#include <limits>

#include "common/base/error.h"
#include "common/base/whole_file.h"
#include "common/run/config.h"
#include "tests/temporary_folder.h"

namespace ronda {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

Config Parsed(const std::string& text) { return Config::FromString(text, "config.toml"); }

std::int64_t BatchSize(Config& config) {
  return config.GetInt("dqn.batch_size", 128, 1, 65536, "transitions in a mini-batch");
}

double LearningRate(Config& config) {
  return config.GetDouble("dqn.learning_rate", 1e-3, 0.0, 1.0, "Adam's");
}

TEST_CASE("Values of every kind are read") {
  Config sut = Parsed(
      "loose = 1\n[dqn]\nbatch_size = 64\nlearning_rate = 0.25\ndouble = false\nloss = 'mse'\n"
      "hidden = [32, 16]\n[dqn.deep]\ndepth = 3\n");
  CHECK(sut.GetInt("loose", 0, 0, 9, "") == 1);
  CHECK(BatchSize(sut) == 64);
  CHECK(LearningRate(sut) == 0.25);
  CHECK_FALSE(sut.GetBool("dqn.double", true, ""));
  CHECK(sut.GetString("dqn.loss", "huber", {"huber", "mse"}, "") == "mse");
  CHECK(sut.GetIntList("dqn.hidden", {64}, 1, 99, "") == std::vector<int>{32, 16});
  CHECK(sut.GetInt("dqn.deep.depth", 1, 1, 9, "") == 3);
  CHECK_NOTHROW(sut.RejectUnknown());
}

TEST_CASE("What is not given has its default") {
  Config sut = Parsed("");
  CHECK(BatchSize(sut) == 128);
  CHECK(LearningRate(sut) == 1e-3);
  CHECK(sut.GetBool("dqn.double", true, ""));
  CHECK(sut.GetString("dqn.loss", "huber", {"huber", "mse"}, "") == "huber");
  CHECK(sut.GetIntList("dqn.hidden", {64, 64}, 1, 99, "") == std::vector<int>{64, 64});
  CHECK_FALSE(sut.Has("dqn.batch_size"));
}

TEST_CASE("A whole number is a number too") {
  Config sut = Parsed("dqn.learning_rate = 1");
  CHECK(LearningRate(sut) == 1.0);
}

TEST_CASE("The ends of a range are within it") {
  Config sut = Parsed("a = 1\nb = 3\n");
  CHECK(sut.GetInt("a", 2, 1, 3, "") == 1);
  CHECK(sut.GetInt("b", 2, 1, 3, "") == 3);
}

TEST_CASE("A value that breaks its rule is refused with place, key, rule and value") {
  Config sut = Parsed(
      "[dqn]\nbatch_size = 0\n  learning_rate = 1.5\ndouble = 1\nloss = \"l1\"\n"
      "hidden = [64, 0]\nname = 3\n");
  CHECK_THROWS_WITH(BatchSize(sut), "config.toml:2:1: dqn.batch_size: must be 1 to 65536, got 0");
  CHECK_THROWS_WITH(LearningRate(sut),
                    "config.toml:3:3: dqn.learning_rate: must be 0 to 1, got 1.5");
  CHECK_THROWS_WITH(sut.GetBool("dqn.double", true, ""),
                    "config.toml:4:1: dqn.double: must be true or false, got 1");
  CHECK_THROWS_WITH(sut.GetString("dqn.loss", "mse", {"huber", "mse"}, ""),
                    "config.toml:5:1: dqn.loss: must be one of huber, mse, got \"l1\"");
  CHECK_THROWS_WITH(sut.GetIntList("dqn.hidden", {64}, 1, 99, ""),
                    "config.toml:6:1: dqn.hidden: each must be 1 to 99, got [64, 0]");
  CHECK_THROWS_WITH(sut.GetString("dqn.name", "", {}, ""),
                    "config.toml:7:1: dqn.name: must be text, got 3");
  CHECK_THROWS_AS(BatchSize(sut), InputError);
}

TEST_CASE("A value of another kind is refused as it was written") {
  Config sut = Parsed("a = 1.0\nb = '1'\nc = 1979-05-27\nd = ['x', 'y']\ne = [1, 2.5]\nf = true\n");
  CHECK_THROWS_WITH(sut.GetInt("a", 0, 0, 9, ""),
                    "config.toml:1:1: a: must be a whole number, got 1.0");
  CHECK_THROWS_WITH(sut.GetDouble("b", 0.0, 0.0, 9.0, ""),
                    "config.toml:2:1: b: must be a number, got \"1\"");
  CHECK_THROWS_WITH(sut.GetString("c", "", {}, ""),
                    "config.toml:3:1: c: must be text, got 1979-05-27");
  CHECK_THROWS_WITH(
      sut.GetIntList("d", {}, 0, 9, ""),
      Catch::Matchers::StartsWith("config.toml:4:1: d: must be a list of whole numbers, got ["));
  CHECK_THROWS_AS(sut.GetIntList("e", {}, 0, 9, ""), InputError);
  CHECK_THROWS_AS(sut.GetInt("f", 0, 0, 9, ""), InputError);
}

TEST_CASE("Numbers that are not finite are refused, whatever the range") {
  Config sut = Parsed("a = nan\nb = inf\nc = -inf\n");
  CHECK_THROWS_WITH(sut.GetDouble("a", 0.0, -kNoLimit, kNoLimit, ""),
                    "config.toml:1:1: a: must be a finite number, got nan");
  CHECK_THROWS_WITH(sut.GetDouble("b", 0.0, 0.0, kNoLimit, ""),
                    "config.toml:2:1: b: must be a finite number, got inf");
  CHECK_THROWS_WITH(sut.GetDouble("c", 0.0, -kNoLimit, 0.0, ""),
                    "config.toml:3:1: c: must be a finite number, got -inf");
}

TEST_CASE("A range that is open at one end names the other") {
  Config sut = Parsed("a = -1\nb = -1.5\nc = 2.5\n");
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  CHECK_THROWS_WITH(sut.GetInt("a", 0, 0, kMost, ""),
                    "config.toml:1:1: a: must be at least 0, got -1");
  CHECK_THROWS_WITH(sut.GetDouble("b", 0.0, 0.0, kNoLimit, ""),
                    "config.toml:2:1: b: must be at least 0, got -1.5");
  CHECK_THROWS_WITH(sut.GetDouble("c", 0.0, -kNoLimit, 1.0, ""),
                    "config.toml:3:1: c: must be at most 1, got 2.5");
}

TEST_CASE("An unknown key is refused, and the nearest known one is named") {
  Config sut = Parsed("[dqn]\nbatch_size = 8\nlerning_rate = 0.1\n");
  BatchSize(sut);
  LearningRate(sut);
  CHECK_THROWS_WITH(sut.RejectUnknown(),
                    "config.toml:3:1: dqn.lerning_rate: unknown key; did you mean "
                    "dqn.learning_rate?");
  CHECK_THROWS_AS(sut.RejectUnknown(), InputError);
}

TEST_CASE("A value where a section belongs is refused") {
  Config sut = Parsed("dqn = 3\n");
  BatchSize(sut);
  CHECK_THROWS_WITH(sut.RejectUnknown(), "config.toml:1:1: dqn: must be a section, got 3");
}

TEST_CASE("What is not TOML is refused with its place, in one line") {
  const auto parse = [] { Parsed("a = 1\nb = = 2\n"); };
  CHECK_THROWS_WITH(parse(), Catch::Matchers::StartsWith("config.toml:2:5: not TOML: ") &&
                                 !Catch::Matchers::Contains("\n"));
  CHECK_THROWS_AS(parse(), InputError);
  CHECK_THROWS_AS(Parsed("a = 1\na = 2\n"), InputError);
  CHECK_THROWS_AS(Parsed("a = \"\xff\""), InputError);
}

TEST_CASE("A quoted key that could pass for a section and a key is refused") {
  CHECK_THROWS_WITH(
      Parsed("\"dqn.batch_size\" = 3\n"),
      "config.toml:1:1: dqn.batch_size: must be letters, digits, _ and -, got \"dqn.batch_size\"");
}

TEST_CASE("An assignment by --set wins over the file and over an earlier --set") {
  Config sut = Parsed("dqn.batch_size = 8\n");
  sut.Set("dqn.batch_size=16");
  sut.Set("dqn.batch_size = 32");
  CHECK(BatchSize(sut) == 32);
}

TEST_CASE("An assignment by --set takes TOML values, and bare words as text") {
  Config sut;
  sut.Set("a=[1, 2]");
  sut.Set("b=maps/a.graph");
  sut.Set("c='quoted'");
  sut.Set("d=x=y");
  sut.Set("e=1\nf=2");  // no second key is smuggled in
  CHECK(sut.GetIntList("a", {}, 0, 9, "") == std::vector<int>{1, 2});
  CHECK(sut.GetString("b", "", {}, "") == "maps/a.graph");
  CHECK(sut.GetString("c", "", {}, "") == "quoted");
  CHECK(sut.GetString("d", "", {}, "") == "x=y");
  CHECK_FALSE(sut.Has("f"));
}

TEST_CASE("Messages about --set quote it") {
  Config sut;
  sut.Set("dqn.batch_size=0");
  CHECK_THROWS_WITH(BatchSize(sut),
                    "--set dqn.batch_size=0: dqn.batch_size: must be 1 to 65536, got 0");
  sut.Set("dqn.batch_size=many");
  CHECK_THROWS_WITH(
      BatchSize(sut),
      "--set dqn.batch_size=many: dqn.batch_size: must be a whole number, got \"many\"");
}

TEST_CASE("A malformed --set is a usage error") {
  const char* text = GENERATE("dqn", "=3", "a b=3", "dqn..x=3", "dqn.=3", ".x=3", "a=", "a=[1", "");
  Config sut;
  CHECK_THROWS_AS(sut.Set(text), UsageError);
  CHECK_THROWS_WITH(sut.Set("dqn"), "--set dqn: must be KEY=VALUE, as in dqn.batch_size=128");
}

TEST_CASE("An option of its own overrides the file and begins the messages") {
  Config sut = Parsed("dqn.batch_size = 8\n");
  sut.Override("dqn.batch_size", std::int64_t{0}, "--batch 0");
  CHECK_THROWS_WITH(BatchSize(sut), "--batch 0: dqn.batch_size: must be 1 to 65536, got 0");
}

TEST_CASE("The resolved text has every key with its doc, rule and default") {
  Config sut = Parsed("dqn.batch_size = 8\n");
  sut.GetString("run.map", "cumberland", {}, "a map");
  BatchSize(sut);
  sut.GetBool("verbose", false, "more lines");
  LearningRate(sut);
  CHECK(sut.Resolved() ==
        "# more lines (true or false; default false)\nverbose = false\n\n"
        "[run]\n# a map (any text; default \"cumberland\")\nmap = \"cumberland\"\n\n"
        "[dqn]\n"
        "# transitions in a mini-batch (1 to 65536; default 128)\nbatch_size = 8\n"
        "# Adam's (0 to 1; default 0.001)\nlearning_rate = 0.001\n");
}

TEST_CASE("The resolved text reads back to the same values") {
  const std::string text = "quote \" backslash \\ tab \t newline \n delete \x7f é";
  const auto read = [&](Config& config) {
    config.GetDouble("a.tenth", 0.1, 0.0, 1.0, "");
    config.GetDouble("a.small", 5e-324, 0.0, 1.0, "two\nlines");
    config.GetDouble("a.large", 1e300, 0.0, kNoLimit, "");
    config.GetDouble("a.whole", 3.0, 0.0, 9.0, "");
    config.GetInt("a.b.least", std::numeric_limits<std::int64_t>::min(),
                  std::numeric_limits<std::int64_t>::min(), 0, "");
    config.GetIntList("a.none", {}, 0, 9, "");
    config.GetIntList("list", {1, 2}, 0, 9, "");
    return config.GetString("a.text", text, {}, "");
  };
  Config first;
  read(first);
  Config second = Parsed(first.Resolved());
  CHECK(read(second) == text);
  CHECK_NOTHROW(second.RejectUnknown());
  CHECK(second.Resolved() == first.Resolved());
  CHECK(second.GetDouble("a.tenth", 0.1, 0.0, 1.0, "") == 0.1);
}

TEST_CASE("A configuration is read from a file, and one that is not there gives the reason") {
  const TemporaryFolder folder;
  WriteWholeFile(folder / "config.toml", "dqn.batch_size = 0\n");
  Config sut = Config::FromFile(folder / "config.toml");
  CHECK_THROWS_WITH(BatchSize(sut), (folder / "config.toml").string() +
                                        ":1:5: dqn.batch_size: must be 1 to 65536, got 0");
  CHECK_THROWS_WITH(Config::FromFile("/no/such.toml"),
                    "/no/such.toml: cannot be read: No such file or directory");
}

}  // namespace
}  // namespace ronda
