#include <catch2/catch.hpp>
#include <map>
#include <utility>

#include "common/base/whole_file.h"
#include "tests/unit/graph/graphs.h"

namespace ronda {
namespace {

using testing::MapFile;
using testing::ReadText;

struct Written {
  PatrolGraph graph;  // read back, lengths from the file
  std::string text;
  std::vector<std::string> warnings;  // of the writer, with the folder left out
};

Written WriteAndRead(const PatrolGraph& graph) {
  const MapFile file(graph.name() + ".graph", "");
  std::vector<std::string> warnings;
  WriteDotGraph(graph, file.path(), &warnings);
  for (std::string& warning : warnings) {
    warning.erase(0, file.path().parent_path().string().size() + 1);
  }
  std::vector<std::string> of_reader;
  PatrolGraph read = ReadGraphFile(file.path(), EdgeLengthSource::kFile, &of_reader);
  CHECK(of_reader.empty());
  return {std::move(read), ReadWholeFile(file.path()), std::move(warnings)};
}

/// By ends, so that the order of edges in a file does not matter.
std::map<std::pair<int, int>, double> Lengths_m(const PatrolGraph& graph) {
  std::map<std::pair<int, int>, double> lengths_m;
  for (const Edge& edge : graph.edges()) {
    lengths_m[std::minmax(edge.source, edge.target)] = edge.length_m;
  }
  return lengths_m;
}

void CheckSame(const PatrolGraph& sut, const PatrolGraph& graph) {
  CHECK(sut.metres_per_px() == graph.metres_per_px());
  REQUIRE(sut.vertex_count() == graph.vertex_count());
  for (int v = 0; v < graph.vertex_count(); ++v) {
    CHECK(sut.positions()[v].x_m == Approx(graph.positions()[v].x_m).epsilon(1e-12).margin(1e-10));
    CHECK(sut.positions()[v].y_m == Approx(graph.positions()[v].y_m).epsilon(1e-12).margin(1e-10));
  }
  const auto lengths_m = Lengths_m(sut);
  const auto expected_m = Lengths_m(graph);
  REQUIRE(lengths_m.size() == expected_m.size());
  for (const auto& [ends, length_m] : expected_m) {
    CAPTURE(ends.first, ends.second);
    REQUIRE(lengths_m.contains(ends));
    CHECK(lengths_m.at(ends) == Approx(length_m).epsilon(1e-9));
  }
}

TEST_CASE("a map that ships, written as .graph, comes back the same whatever lengths are read") {
  const std::string name = GENERATE("4nodes", "cumberland", "grid", "milwaukee");
  CAPTURE(name);
  const PatrolGraph graph = testing::ShippedMap(name);

  const Written sut = WriteAndRead(graph);
  CheckSame(sut.graph, graph);
  CheckSame(ReadText(name + ".graph", sut.text).graph, graph);
  CHECK(WriteAndRead(sut.graph).text == sut.text);
  CHECK(sut.text.find("00000000") == std::string::npos);  // pixels stay whole
}

TEST_CASE(
    "random graphs come back from .graph, also with negative places and lengths of their own") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 21));
  CAPTURE(seed);
  GraphData data = testing::RandomGraphData(30, 12, seed);
  for (Position& at : data.positions) at.x_m -= 50.0;
  data.name = "random";
  data.metres_per_px = seed % 2 == 0 ? 0.05 : 3.0;
  data.edges[seed].length_m *= 1.5;
  const PatrolGraph graph(data);

  const Written sut = WriteAndRead(graph);

  CheckSame(sut.graph, graph);
  REQUIRE(sut.warnings.size() == 1);
  CHECK_THAT(sut.warnings[0], Catch::Contains("--length file"));
}

TEST_CASE("a .graph file goes to JSON and back without a difference") {
  GraphData data = testing::RandomGraphData(20, 9, 7);
  data.edges[3].length_m *= 2.0;
  data.name = "m";
  const std::string text = WriteAndRead(PatrolGraph(data)).text;
  const PatrolGraph graph = ReadText("m.graph", text, EdgeLengthSource::kFile).graph;
  const MapFile json("m.json", "");

  WriteNodeLink(graph, json.path());
  const PatrolGraph sut = ReadGraphFile(json.path(), EdgeLengthSource::kEuclidean, nullptr);

  CheckSame(sut, graph);
  CheckSame(WriteAndRead(sut).graph, graph);
}

TEST_CASE("a .graph file has size, offset and words of the compass with y to the north") {
  GraphData data{.name = "star",
                 .vertex_ids = {"0", "1", "2", "3"},
                 .positions = {{-1.0, 0.0}, {4.5, 0.0}, {-1.0, 3.0}, {-3.0, -2.0}},
                 .edges = {{0, 1, 5.5}, {0, 2, 3.0}, {0, 3, std::hypot(2.0, 2.0)}},
                 .metres_per_px = 0.5};

  const Written sut = WriteAndRead(PatrolGraph(data));

  CHECK(sut.warnings.empty());
  CHECK(
      sut.text.starts_with("4\n15\n10\n0.5\n-3\n-2\n\n"
                           "0\n4\n4\n3\n1\nE\n11\n2\nN\n6\n3\nSW\n5.65685424949238\n\n"
                           "1\n15\n4\n1\n0\nW\n11\n\n"));
}

TEST_CASE("each thing that a .graph file cannot hold is named in a warning of its own") {
  GraphData data{.name = "yard",
                 .vertex_ids = {"0", "door", "x"},
                 .positions = {{0.0, 0.0}, {3.0, 4.0}, {3.0, 0.0}},
                 .edges = {{0, 1, 6.0}, {1, 2, 4.0}, {0, 2, 3.0}},
                 .priorities = {1.0, 2.0, 1.0},
                 .source = "by hand",
                 .shortest_closed_walk = ClosedWalk{{0, 1, 2}, 13.0, "by hand"}};
  const MapFile file("m.graph", "");
  std::vector<std::string> sut;

  WriteDotGraph(PatrolGraph(data), file.path(), &sut);

  REQUIRE(sut.size() == 6);
  CHECK_THAT(sut[0],
             Catch::StartsWith(file.path().string()) && Catch::Contains("'door' becomes 1"));
  CHECK_THAT(sut[1], Catch::Contains("the edge 0 - door is 6 m long, its ends are 5 m apart"));
  CHECK_THAT(sut[2], Catch::Contains("priorities"));
  CHECK_THAT(sut[3], Catch::Contains("closed walk of 13 m"));
  CHECK_THAT(sut[4], Catch::Contains("the name 'yard'"));
  CHECK_THAT(sut[5], Catch::Contains("the source 'by hand'"));
}

TEST_CASE("what cannot be written as .graph is an error that leaves the file as it was") {
  GraphData data = testing::RandomGraphData(3, 0, 1);
  data.positions[0].x_m = 1e300;
  data.metres_per_px = 1e-10;
  const MapFile file("m.graph", "before");
  CHECK_THROWS_AS(WriteDotGraph(PatrolGraph(data), file.path(), nullptr), InputError);
  CHECK(ReadWholeFile(file.path()) == "before");
  CHECK_THROWS_WITH(WriteDotGraph(testing::ShippedMap("grid"), "/nonexistent/m.graph", nullptr),
                    Catch::StartsWith("/nonexistent/m.graph: cannot be written"));
}

}  // namespace
}  // namespace ronda
