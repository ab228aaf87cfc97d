#include <catch2/catch.hpp>

#include "tests/unit/graph/graphs.h"

namespace ronda {
namespace {

using testing::ErrorOf;
using testing::ReadText;

const std::string kHeader = "2\n100 50\n0.5\n10\n-20\n\n";
// Two vertices 5 px apart, the cost column 8.
const std::string kPair = kHeader + "0\n0 0\n1\n1 E 8\n\n1\n3 4\n1\n0 W 8\n";

TEST_CASE("a .graph file gives positions and lengths in metres") {
  const auto [sut, warnings] = ReadText("pair.graph", kPair);

  CHECK(sut.name() == "pair");
  CHECK(sut.metres_per_px() == 0.5);
  CHECK(sut.positions()[1].x_m == 11.5);
  CHECK(sut.positions()[1].y_m == -18.0);
  CHECK(sut.edge_length_m(0, 1) == 2.5);
  CHECK(warnings.empty());
}

TEST_CASE("the cost column of a .graph file is the length where asked for") {
  CHECK(ReadText("pair.graph", kPair, EdgeLengthSource::kFile).graph.edge_length_m(0, 1) == 4.0);
}

TEST_CASE("line ends, blank lines, decimals and signs of a .graph file may vary") {
  const auto sut =
      ReadText("odd.graph", "2 100 50 1\r\n0 0 0\t-1.5 0 1 1 E 4\r\n\r\n1 0 0 1 0 W 4").graph;
  CHECK(sut.positions()[0].x_m == -1.5);
}

TEST_CASE("an error in a .graph file names line, rule and value") {
  const auto [text, message] = GENERATE_COPY(table<std::string, std::string>({
      {"",
       "m.graph:1: the number of vertices must be an integer in 2 … 10000, got the end of the "
       "file"},
      {"0 1 1 1 0 0", "m.graph:1: the number of vertices must be an integer in 2 … 10000, got '0'"},
      {"999999999999 1 1 1 0 0",
       "m.graph:1: the number of vertices must be an integer in 2 … 10000, got '999999999999'"},
      {"2.5 1 1 1 0 0",
       "m.graph:1: the number of vertices must be an integer in 2 … 10000, got '2.5'"},
      {"2\n1 1\n0\n", "m.graph:3: metres per px must be a positive finite number, got '0'"},
      {"2\n1 1\ninf\n", "m.graph:3: metres per px must be a positive finite number, got 'inf'"},
      {"2\n1 1\n1\nx", "m.graph:4: the offset x must be a finite number, got 'x'"},
      {kHeader + "1", "m.graph:7: the id of vertex 0 must be 0 (in order), got '1'"},
      {kHeader + "0 0 0 1 1 E 8\n0", "m.graph:8: the id of vertex 1 must be 1 (in order), got '0'"},
      {kHeader + "0\nnan", "m.graph:8: vertex 0: x must be a finite number, got 'nan'"},
      {kHeader + "0\n1\n1e999", "m.graph:9: vertex 0: y must be a finite number, got '1e999'"},
      {kHeader + "0\n1\n1\n-1",
       "m.graph:10: vertex 0: the number of its neighbours must be an integer in 0 … 1048576, got "
       "'-1'"},
      {kHeader + "0 0 0 1\n99 E 8",
       "m.graph:8: vertex 0: a neighbour's id must be an integer in 0 … 1, got '99'"},
      {kHeader + "0 0 0 1\n0 E 8",
       "m.graph:8: vertex 0: a neighbour must be another vertex, got 0"},
      {kHeader + "0 0 0 1\n1 8",
       "m.graph:8: vertex 0: a compass word must follow neighbour 1, got '8'"},
      {kHeader + "0 0 0 1\n1\nE\n-8",
       "m.graph:10: vertex 0: the cost to neighbour 1 must be a finite number of at least 0, got "
       "'-8'"},
      {kHeader + "0 0 0 1\n1\nE\nnan",
       "m.graph:10: vertex 0: the cost to neighbour 1 must be a finite number of at least 0, got "
       "'nan'"},
      {kHeader + "0 0 0 1\n1\nE\n8\n",
       "m.graph:11: the id of vertex 1 must be 1 (in order), got the end of the file"},
      {kHeader + "0 0 0 1 1 E",
       "m.graph:7: vertex 0: the cost to neighbour 1 must be a finite number of at least 0, got "
       "the "
       "end of the file"},
      {kPair + "2", "m.graph:16: the file must end after its 2 vertices, got '2'"},
      {kHeader + "0 0 0 0\n1 3 4 0\n",
       "m.graph: a graph must be connected, got no path from vertex 0 to 1"},
      {kHeader + "0 1e308 0 1 1 E 1\n1 -1e308 0 1 0 W 1\n",
       "m.graph: edge 0 - 1: a length must be positive and finite, got inf"},
      {std::string(60, '\x1b'),
       "m.graph:1: the number of vertices must be an integer in 2 … 10000, got '" +
           std::string(40, '?') + "…'"},
  }));
  CAPTURE(text);
  CHECK(ErrorOf("m.graph", text) == message);
}

TEST_CASE("what is odd in a .graph file is read, with a warning that names it") {
  SECTION("a neighbour twice keeps the shortest cost") {
    const auto [sut, warnings] = ReadText(
        "m.graph", kHeader + "0 0 0 2 1 E 8\n1 E 6\n1 3 4 1 0 W 6\n", EdgeLengthSource::kFile);
    CHECK(warnings == std::vector<std::string>{
                          "m.graph:8: vertex 0 lists neighbour 1 more than once; the shortest is "
                          "kept"});
    CHECK(sut.edge_length_m(0, 1) == 3.0);
    CHECK(sut.edge_count() == 1);
  }
  SECTION("a one-way arc is taken both ways") {
    const auto [sut, warnings] = ReadText("m.graph", kHeader + "0 0 0 0\n1 3 4 1\n0 W 8\n");
    CHECK(warnings ==
          std::vector<std::string>{
              "m.graph:9: the arc from 1 to 0 is one-way; it is taken both ways (vertex "
              "0 does not list 1)"});
    CHECK(sut.edge_length_m(0, 1) == 2.5);
  }
  SECTION("an edge on one point is 1 mm long") {
    const auto [sut, warnings] = ReadText("m.graph", kHeader + "0 3 4 1\n1 E 8\n1 3 4 1\n0 W 8\n");
    CHECK(warnings ==
          std::vector<std::string>{
              "m.graph:8: vertices 0 and 1 stand on the same point; their edge is taken "
              "as 1 mm long"});
    CHECK(sut.edge_length_m(0, 1) == 0.001);
  }
  SECTION("a cost of 0 is 1 mm") {
    const auto [sut, warnings] =
        ReadText("m.graph", kHeader + "0 0 0 1\n1 E 0\n1 3 4 1\n0 W 0\n", EdgeLengthSource::kFile);
    CHECK(warnings == std::vector<std::string>{
                          "m.graph:8: the cost between 0 and 1 is 0; their edge is taken as 1 mm "
                          "long"});
    CHECK(sut.edge_length_m(0, 1) == 0.001);
  }
  SECTION("costs that differ keep the smaller") {
    const auto [sut, warnings] =
        ReadText("m.graph", kHeader + "0 0 0 1\n1 E 8\n1 3 4 1\n0 W 7\n", EdgeLengthSource::kFile);
    CHECK(warnings ==
          std::vector<std::string>{
              "m.graph:8: the costs between 0 and 1 differ (8 and 7); the smaller is kept"});
    CHECK(sut.edge_length_m(0, 1) == 3.5);
  }
}

TEST_CASE("every cut of a .graph file is an error, not a smaller map") {
  for (std::size_t length = 0; length + 1 < kPair.size(); ++length) {
    CAPTURE(length);
    CHECK(ErrorOf("m.graph", kPair.substr(0, length)) != "no error");
  }
}

}  // namespace
}  // namespace ronda
