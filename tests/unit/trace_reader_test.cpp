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

TEST_CASE("The mean of the idleness in a trace is the AGI that the evaluation reports") {
  const std::string strategy = GENERATE("cr", "cyclic");  // cyclic: robots start on edges
  const testing::EvaluationMap map("cumberland");
  const TemporaryFolder folder;
  TraceWriter writer(folder / "t.csv", map.graph, "cumberland");
  const auto make = [&] { return MakeStrategy(strategy, map.context()); };
  const auto result =
      Evaluate(map.context(), make, {.episodes = 3, .agents = 7, .travel_noise = 0.05}, &writer);
  writer.Commit();
  REQUIRE(result);

  TraceReader trace(folder / "t.csv", map.graph, "maps/cumberland.json");
  const MapUsage sut = MeasureUsage(trace, map.graph);

  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  CHECK(mean(sut.mean_idleness_s) == Approx(mean(result->agi_s())).epsilon(1e-6));
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
  writer.Starts(0, std::vector<RobotStart>{{.vertex = 0}});
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
      {start + "0,1,0,1,pause\n", "t.csv:4: event must be start, visit or end, got \"pause\""},
      {start + "0,1,1,1,visit\n", "t.csv:4: robot must be one of the 1 that started, got 1"},
      {start + "0,1,0,2,visit\n0,2,0,1,visit\n",
       "t.csv:5: vertex must be a neighbour of '2', where robot 0 was, got \"1\""},
      {start + "0,2,0,1,visit\n0,1,0,0,visit\n",
       "t.csv:5: time_s must be at least the 2 before it, got 1"},
      {start + "0,0,2,1,start\n", "t.csv:4: robot must be 1, the next to start, got 2"},
      {start + "0,1,1,1,start\n", "t.csv:4: a start must be at time 0, before all visits, got 1"},
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
