#include "deploy/compare_arguments.h"

#include <catch2/catch.hpp>

#include "common/base/error.h"
#include "deploy/value_list.h"

namespace ronda {
namespace {

TEST_CASE("Whole numbers come one by one and as ranges with both ends, each once") {
  const auto parse = [](const std::vector<std::string>& texts) {
    return ParseWholeNumbers("--agents", texts, 1, 10'000);
  };
  CHECK(parse({"4", "2"}) == std::vector<int>{4, 2});
  CHECK(parse({"1..4"}) == std::vector<int>{1, 2, 3, 4});
  CHECK(parse({"2..12:5"}) == std::vector<int>{2, 7, 12});
  CHECK(parse({"2..8:5", "7..8", "3..3"}) == std::vector<int>{2, 7, 8, 3});
  CHECK(parse({"1..10000:9999"}) == std::vector<int>{1, 10'000});
  CHECK(parse({"1..2:2147483647"}) == std::vector<int>{1});
}

TEST_CASE("A list that is none is refused with option, rule and value") {
  for (const char* bad : {"", "two", "2.5", "0", "10001", "0..4", "9000..10001", "4..2", "2..",
                          "..4", "1..4:0", "1..4:", "1..4:-1", "1..4..6", "2 ", "99999999999"}) {
    CAPTURE(bad);
    CHECK_THROWS_WITH(ParseWholeNumbers("--agents", {"3", bad}, 1, 10'000),
                      "--agents must be whole numbers in 1 … 10000, or ranges of them such as "
                      "2..12 or 2..12:2, got '" +
                          std::string(bad) + "'");
    CHECK_THROWS_AS(ParseWholeNumbers("--agents", {bad}, 1, 10'000), UsageError);
  }
  CHECK_THROWS_WITH(ParseTexts("--map", {"grid", ""}),
                    "--map must be values with commas between them, got ''");
}

TEST_CASE("Conditions are the cross product of the lists, each once") {
  CompareArguments arguments;
  arguments.conditions = {{"noise", "none,0.25,0"}, {"fail", "1@5/2@6,none"}, {"stay", ""}};
  arguments.options.seed = 7;

  const auto sut = ConditionsOf(arguments);

  std::vector<std::string> labels;
  for (const EvaluationOptions& each : sut) {
    CHECK(each.seed == 7);
    labels.push_back(Label(each.conditions));
  }
  CHECK(labels == std::vector<std::string>{"fail 1@5 s, fail 2@6 s", "",
                                           "noise 0.25, fail 1@5 s, fail 2@6 s", "noise 0.25"});
}

TEST_CASE("A list of conditions with a bad or an empty value is refused by its name") {
  CompareArguments arguments;
  arguments.conditions = {{"noise", "0,x"}};
  CHECK_THROWS_WITH(ConditionsOf(arguments), "noise: must be a number, got 'x'");
  for (const char* bad : {"0,", ",0", "0,,1", ","}) {
    CAPTURE(bad);
    arguments.conditions = {{"message-loss", bad}};
    CHECK_THROWS_WITH(ConditionsOf(arguments),
                      "--message-loss must be values with commas between them, got ''");
  }
}

TEST_CASE("Contestants are policies and then strategies, of which all stands for many, each once") {
  CompareArguments arguments;
  arguments.policies = {"a", "b", "a"};
  arguments.strategies = {"cr", "all"};

  const auto sut = ContestantsOf(arguments);

  REQUIRE(sut.size() == 2 + AllStrategyNames().size());
  CHECK(sut[1] == Contestant{.kind = ContestantKind::kPolicy, .name = "b"});
  CHECK(sut[2] == Contestant{.name = "cr"});
  CHECK(sut[3] == Contestant{.name = AllStrategyNames().front()});
}

TEST_CASE("Nothing to compare is refused") {
  CHECK_THROWS_WITH(ContestantsOf({}), "nothing to compare: give --policy or --strategies");
}

}  // namespace
}  // namespace ronda
