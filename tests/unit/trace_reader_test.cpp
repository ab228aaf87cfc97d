#include "common/evaluation/trace_reader.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <numeric>

#include "common/base/error.h"
#include "common/evaluation/map_usage.h"
#include "common/evaluation/protocol.h"
#include "tests/temporary_folder.h"
#include "tests/unit/evaluation_map.h"

namespace ronda {
namespace {

const std::string kFirst = "# warmup_s=10.000000000 window_s=20.000000000 map=maps/4nodes.json\n";
const std::string kHead = kFirst + "episode,time_s,robot,vertex,event\n";

/// The four vertices of 4nodes: 0 - 1, 0 - 2, 0 - 3, 1 - 3, 2 - 3.
PatrolGraph FourNodes(const std::string& first_id = "0") {
  return PatrolGraph({.name = "4nodes",
                      .vertex_ids = {first_id, "1", "2", "3"},
                      .positions = {{30, 25}, {70, 25}, {30, 50}, {70, 50}},
                      .edges = {{0, 1, 40}, {0, 2, 25}, {0, 3, 47}, {1, 3, 25}, {2, 3, 40}}});
}

MapUsage UsageOf(const std::string& text, const PatrolGraph& graph = FourNodes()) {
  const TemporaryFolder folder;
  const auto path = folder / "t.csv";
  std::ofstream(path, std::ios::binary) << text;
  TraceReader trace(path, graph, "4nodes");
  return MeasureUsage(trace, graph);
}

/// With the folder left out.
std::string ErrorOf(const std::string& text) {
  try {
    UsageOf(text);
  } catch (const InputError& error) {
    const std::string what = error.what();
    return what.substr(what.find("t.csv"));
  }
  return "no error";
}

TEST_CASE("Idleness and traffic of a trace are those of its window, by hand") {
  const MapUsage sut = UsageOf(kHead +
                               "0,0.000000000,0,0,start\n"
                               "0,8.000000000,0,1,visit\n"  // in the warm-up
                               "0,15.000000000,0,0,visit\n"
                               "0,25.000000000,0,1,visit\n"
                               "0,30.000000000,-1,-1,end\n");

  // 0 is idle for 10 … 15 s, then 0 … 15 s: (62.5 + 112.5) / 20. 1: 2 … 17 s, 0 … 5 s.
  CHECK(sut.mean_idleness_s[0] == Approx(8.75));
  CHECK(sut.mean_idleness_s[1] == Approx((142.5 + 12.5) / 20.0));
  CHECK(sut.mean_idleness_s[2] == Approx(20.0));  // never visited: 10 … 30 s
  CHECK(sut.traversals_per_hour == std::vector<double>{2 * 180.0, 0.0, 0.0, 0.0, 0.0});
}

TEST_CASE("Idleness and traffic are means over episodes, and each begins afresh") {
  const std::string idle = ",0,0,0,start\n", end = ",30,-1,-1,end\n";
  const MapUsage sut =
      UsageOf(kHead + "0" + idle + "0" + end + "1" + idle + "1,20,0,2,visit\n1" + end);
  CHECK(sut.mean_idleness_s[1] == Approx(20.0));
  CHECK(sut.mean_idleness_s[2] == Approx(0.5 * (20.0 + (150.0 + 50.0) / 20.0)));
  CHECK(sut.traversals_per_hour[1] == Approx(90.0));
}

TEST_CASE("A vertex where a robot stays is not idle, and who joins and fails is followed") {
  const MapUsage sut = UsageOf(kHead +
                               "0,0,0,0,start\n"
                               "0,12,0,1,visit\n"
                               "0,14,3,0,join\n"
                               "0,14,3,0,visit\n"
                               "0,16,3,1,visit\n"  // in the stay of robot 0, which ends at 22
                               "0,20,3,-1,fail\n"
                               "0,22,0,1,visit\n"
                               "0,24,3,0,join\n"  // on an edge: no visit
                               "0,27,3,2,visit\n"
                               "0,30,-1,-1,end\n");
  // 0: 10 … 14 s, then 0 … 16 s. 1: 10 … 12 s, then none, then 0 … 8 s. 2: 10 … 27 s, then 0 … 3 s.
  CHECK(sut.mean_idleness_s[0] == Approx((48.0 + 128.0) / 20.0));
  CHECK(sut.mean_idleness_s[1] == Approx((22.0 + 32.0) / 20.0));
  CHECK(sut.mean_idleness_s[2] == Approx((314.5 + 4.5) / 20.0));
  CHECK(sut.traversals_per_hour == std::vector<double>{2 * 180.0, 180.0, 0.0, 0.0, 0.0});
}

TEST_CASE("The mean of the idleness in a trace is the AGI that the evaluation reports") {
  const std::string strategy = GENERATE("cr", "cyclic");  // cyclic: robots start on edges
  const Attrition attrition =
      GENERATE(Attrition{}, Attrition{.changes = {{.time_s = 50.0, .robot = 2, .joins = true},
                                                  {.time_s = 900.0, .robot = 6}}});
  const testing::EvaluationMap map("cumberland");
  const TemporaryFolder folder;
  TraceWriter writer(folder / "t.csv", map.graph, "cumberland");
  const auto make = [&] { return MakeStrategy(strategy, map.context()); };
  const EvaluationOptions options{
      .episodes = 3, .agents = 7, .conditions = {.travel_noise = 0.05, .attrition = attrition}};
  const auto result = Evaluate(map.context(), make, options, &writer);
  writer.Commit();
  REQUIRE(result);

  TraceReader trace(folder / "t.csv", map.graph, "maps/cumberland.json");
  const MapUsage sut = MeasureUsage(trace, map.graph);

  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  CHECK(mean(sut.mean_idleness_s) == Approx(mean(result->agi_s())).epsilon(1e-6));
  if (attrition != Attrition{}) return;
  // Seven robots at 1 m/s, up to the noise and to what is cut at both ends of the window.
  double metres_per_hour = 0.0;
  for (int e = 0; e < map.graph.edge_count(); ++e) {
    metres_per_hour += sut.traversals_per_hour[e] * map.graph.edges()[e].length_m;
  }
  CHECK(metres_per_hour == Approx(7 * 3600.0).epsilon(0.01));
}

TEST_CASE("Ids with commas and quotes go through a trace and back") {
  const PatrolGraph graph = FourNodes(" a,\"b\" ");
  const TemporaryFolder folder;
  TraceWriter writer(folder / "t.csv", graph, "4nodes");
  writer.Begin(0.0, 5.0);
  writer.Event(0, 0.0, 0, 0, "start");
  writer.End(0, 5.0);
  writer.Commit();

  TraceReader sut(folder / "t.csv", graph, "4nodes");

  CHECK(sut.window_s() == 5.0);
  CHECK(sut.Next()->vertex == 0);
  CHECK(sut.Next()->kind == TraceEventKind::kEnd);
  CHECK_FALSE(sut.Next());
}

TEST_CASE("An error in a trace names file, line, rule and value") {
  const std::string start = kHead + "0,0,0,0,start\n";
  const auto [text, message] = GENERATE_COPY(table<std::string, std::string>({
      {"x\n", "t.csv:1: a trace must begin with '# warmup_s=… window_s=… map=…', got \"x\""},
      {"\x1b[0m\n",
       "t.csv:1: a trace must begin with '# warmup_s=… window_s=… map=…', got "
       "\"\\x1b[0m\""},
      {"# warmup_s=a window_s=2 map=4nodes\n",
       "t.csv:1: warmup_s must be a finite number of at least 0, got \"a\""},
      {"# warmup_s=1 window_s=0 map=4nodes\n", "t.csv:1: window_s must be positive, got 0"},
      {"# warmup_s=1 window_s=2 map=grid\n",
       "t.csv:1: the trace must be of the map '4nodes', got \"grid\""},
      {kFirst, "t.csv:1: a line must have the fields episode,time_s,robot,vertex,event"},
      {kFirst + "episode,time_s\n",
       "t.csv:2: a line must have the fields episode,time_s,robot,vertex,event"},
      {kHead, "t.csv:2: the end of episode 0 must follow, got the file's end"},
      {start, "t.csv:3: the end of episode 0 must follow, got the file's end"},
      {start.substr(0, start.size() - 1), "t.csv: a trace must end with a line end; it was cut"},
      {start + "0,1,0\n", "t.csv:4: a line must have the fields episode,time_s,robot,vertex,event"},
      {start + "0,1,0,1,visit,6\n",
       "t.csv:4: a line must have the fields episode,time_s,robot,vertex,event"},
      {start + "0,1,0,\"1,visit\n",
       "t.csv:4: a line must have the fields episode,time_s,robot,vertex,event"},
      {start + "x,1,0,1,visit\n", "t.csv:4: episode must be an integer of at least 0, got \"x\""},
      {start + "1,1,0,1,visit\n", "t.csv:4: episode must be 0, got 1"},
      {start + "0,nan,0,1,visit\n",
       "t.csv:4: time_s must be a finite number of at least 0, got \"nan\""},
      {start + "0,1,-2,1,visit\n", "t.csv:4: robot must be an integer of at least 0, got \"-2\""},
      {start + "0,1,0,9,visit\n", "t.csv:4: vertex must be an id of the map's vertices, got \"9\""},
      {start + "0,1,0,1,pause\n",
       "t.csv:4: event must be start, visit, join, fail or end, got \"pause\""},
      {start + "0,1,1,1,visit\n", "t.csv:4: the robot of a visit must be on patrol, got 1"},
      {start + "0,1,0,2,visit\n0,2,0,1,visit\n",
       "t.csv:5: vertex must be '2', where robot 0 was, or a neighbour of it, got \"1\""},
      {start + "0,2,0,1,visit\n0,1,0,0,visit\n",
       "t.csv:5: time_s must be at least the 2 before it, got 1"},
      {start + "0,0,0,1,start\n", "t.csv:4: robot must be above 0, the last to start, got 0"},
      {start + "0,1,1,1,start\n",
       "t.csv:4: a start must be at time 0, before all other events, got 1"},
      {start + "0,1,0,1,join\n", "t.csv:4: the robot of a join must not be on patrol, got 0"},
      {start + "0,1,0,-1,fail\n",
       "t.csv:4: the robot of a fail must be on patrol, and not the last one, got 0"},
      {start + "0,1,7,-1,fail\n",
       "t.csv:4: the robot of a fail must be on patrol, and not the last one, got 7"},
      {start + "0,1,1,1,join\n0,2,0,-1,fail\n0,3,0,1,visit\n",
       "t.csv:6: the robot of a visit must be on patrol, got 0"},
      {start + "0,29,-1,-1,end\n", "t.csv:4: the end must be at 30 s, warm-up plus window, got 29"},
      {kHead + "0,30,-1,-1,end\n", "t.csv:3: an episode must begin with starts, got its end"},
  }));
  CAPTURE(text);
  CHECK(ErrorOf(text) == message);
}

TEST_CASE("A trace that is not there is an error that names it") {
  const PatrolGraph graph = FourNodes();
  CHECK_THROWS_WITH(TraceReader("/nowhere/t.csv", graph, "4nodes"),
                    "/nowhere/t.csv: a trace must be a file that can be read");
  CHECK_THROWS_AS(TraceReader("/tmp", graph, "4nodes"), InputError);
}

TEST_CASE("Every cut of a trace is an error") {
  const std::string whole = kHead + "0,0.0,0,0,start\n0,8.0,0,1,visit\n0,30.0,-1,-1,end\n";
  REQUIRE(ErrorOf(whole) == "no error");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    CAPTURE(length);
    CHECK(ErrorOf(whole.substr(0, length)) != "no error");
  }
}

}  // namespace
}  // namespace ronda
