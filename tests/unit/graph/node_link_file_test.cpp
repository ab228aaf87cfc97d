#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "common/base/whole_file.h"
#include "tests/unit/graph/graphs.h"

namespace ronda {
namespace {

using testing::ErrorOf;
using testing::MapFile;
using testing::ReadText;

const std::string kNodes = R"("nodes": [{"id": 7, "pos": [0, 0]}, {"id": "b", "pos": [3, 4]}])";

std::string WithLinks(const std::string& links) {
  return "{" + kNodes + R"(, "links": [)" + links + "]}";
}
std::string WithNodes(const std::string& nodes) {
  return R"({"nodes": [)" + nodes + R"(], "links": []})";
}
std::string WithGraph(const std::string& attributes) {
  return "{" + kNodes + R"(, "links": [{"source": 7, "target": "b"}], "graph": {)" + attributes +
         "}}";
}

TEST_CASE("node-link JSON gives ids, positions and the distance as length") {
  const auto [sut, warnings] = ReadText("pair.json", WithLinks(R"({"source": 7, "target": "b"})"));

  CHECK(sut.name() == "pair");
  CHECK(sut.vertex_id(0) == "7");
  CHECK(sut.vertex_id(1) == "b");
  CHECK(sut.positions()[1].y_m == 4.0);
  CHECK(sut.edge_length_m(0, 1) == 5.0);
  CHECK(sut.metres_per_px() == 1.0);
  CHECK_FALSE(sut.shortest_closed_walk());
  CHECK(warnings.empty());
}

TEST_CASE("an explicit length wins over the distance") {
  const auto source = GENERATE(EdgeLengthSource::kEuclidean, EdgeLengthSource::kFile);
  const auto sut =
      ReadText("m.json", WithLinks(R"({"source": 7, "target": "b", "length": 9})"), source).graph;
  CHECK(sut.edge_length_m(0, 1) == 9.0);
}

TEST_CASE("a node without a priority has 1") {
  const auto sut = ReadText("m.json", R"({"nodes": [{"id": 0, "pos": [0, 0]},
      {"id": 1, "pos": [1, 0], "priority": 2.5}], "links": [{"source": 0, "target": 1}]})")
                       .graph;
  CHECK(sut.priorities() == std::vector<double>{1.0, 2.5});
}

TEST_CASE("priorities are written only where not all are alike") {
  GraphData data = testing::RandomGraphData(3, 0, 1);
  data.priorities =
      GENERATE(std::vector<double>{2.0, 2.0, 2.0}, std::vector<double>{1.0, 1e-6, 0.3});
  const PatrolGraph graph(data);
  const MapFile file("m.json", "");

  WriteNodeLink(graph, file.path());

  CHECK((ReadWholeFile(file.path()).find("priority") == std::string::npos) == graph.unweighted());
  CHECK(ReadGraphFile(file.path(), EdgeLengthSource::kEuclidean, nullptr).priorities() ==
        graph.priorities());
}

TEST_CASE("links may be called edges") {
  const auto sut =
      ReadText("m.json", "{" + kNodes + R"(, "edges": [{"source": 7, "target": "b"}]})").graph;
  CHECK(sut.edge_count() == 1);
}

TEST_CASE("a directed file counts each edge once when it has both arcs") {
  const auto [sut, warnings] = ReadText("m.json", R"({"directed": true, )" + kNodes +
                                                      R"(, "links": [{"source": 7, "target": "b"},
                                            {"source": "b", "target": 7}]})");
  CHECK(sut.edge_count() == 1);
  CHECK(warnings.empty());
}

TEST_CASE("the attributes of the whole map are read") {
  const auto sut = ReadText("m.json", WithGraph(R"("name": "yard", "source": "measured",
      "metres_per_px": 0.5, "other": [1],
      "shortest_closed_walk": {"length_m": 10, "vertices": [7, "b"], "source": "by hand"})"))
                       .graph;
  CHECK(sut.name() == "yard");
  CHECK(sut.source() == "measured");
  CHECK(sut.metres_per_px() == 0.5);
  REQUIRE(sut.shortest_closed_walk());
  CHECK(sut.shortest_closed_walk()->vertices == std::vector<int>{0, 1});
  CHECK(sut.shortest_closed_walk()->source == "by hand");
}

TEST_CASE("a parallel edge keeps the shortest, with a warning that names it") {
  const auto [sut, warnings] = ReadText("m.json", WithLinks(R"(
      {"source": 7, "target": "b", "length": 9}, {"source": "b", "target": 7, "length": 6})"));
  CHECK(sut.edge_length_m(0, 1) == 6.0);
  CHECK(warnings == std::vector<std::string>{
                        "m.json: links[1]: a parallel edge between b and 7; the shortest is kept"});
}

TEST_CASE("an edge between nodes on one point is 1 mm, with a warning that names it") {
  const auto [sut, warnings] =
      ReadText("m.json", R"({"nodes": [{"id": 0, "pos": [1, 1]}, {"id": 1, "pos": [1, 1]}],
                    "links": [{"source": 0, "target": 1}]})");
  CHECK(sut.edge_length_m(0, 1) == 0.001);
  CHECK(warnings == std::vector<std::string>{"m.json: links[0]: nodes 0 and 1 stand on the same "
                                             "point; their edge is taken as 1 mm long"});
}

TEST_CASE("an error in a node names element, rule and value") {
  const auto [text, message] = GENERATE_COPY(table<std::string, std::string>({
      {"[]", "m.json: the file: must hold an object, got a list of 0"},
      {"{}", "m.json: the file: must have `nodes`"},
      {R"({"nodes": 3})", "m.json: nodes: must be a list, got 3"},
      {R"({"nodes": []})", "m.json: the file: must have `links`"},
      {WithNodes("5"), "m.json: nodes[0]: must be an object, got 5"},
      {WithNodes(R"({"pos": [0, 0]})"), "m.json: nodes[0]: must have `id`"},
      {WithNodes(R"({"id": 1.5, "pos": [0, 0]})"),
       "m.json: nodes[0].id: must be an integer or a string of 1 to 200 bytes without control "
       "characters, got 1.5"},
      {WithNodes(R"({"id": true, "pos": [0, 0]})"),
       "m.json: nodes[0].id: must be an integer or a string of 1 to 200 bytes without control "
       "characters, got true"},
      {WithNodes(R"({"id": "", "pos": [0, 0]})"),
       "m.json: nodes[0].id: must be an integer or a string of 1 to 200 bytes without control "
       "characters, got \"\""},
      {WithNodes(R"({"id": "a\u001b[2J", "pos": [0, 0]})"),
       "m.json: nodes[0].id: must be an integer or a string of 1 to 200 bytes without control "
       "characters, got \"a\\u001b[2J\""},
      {WithNodes(R"({"id": ")" + std::string(201, 'a') + R"(", "pos": [0, 0]})"),
       "m.json: nodes[0].id: must be an integer or a string of 1 to 200 bytes without control "
       "characters, got \"" +
           std::string(59, 'a') + "…"},
      {WithNodes(R"({"id": 1})"), "m.json: nodes[0]: must have `pos`"},
      {WithNodes(R"({"id": 1, "pos": [0]})"),
       "m.json: nodes[0].pos: must be a list of two numbers, x and y in metres, got a list of 1"},
      {WithNodes(R"({"id": 1, "pos": [0, "1"]})"),
       "m.json: nodes[0].pos[1]: must be a finite number, got \"1\""},
      {WithNodes(R"({"id": 1, "pos": [0, 1]}, {"id": "1", "pos": [2, 2]})"),
       "m.json: nodes[1].id: must differ from the id of nodes[0], got \"1\""},
      {WithNodes(R"({"id": 1, "pos": [0, 1]})"),
       "m.json: a graph must have at least 2 vertices, got 1"},
      {WithNodes(R"({"id": 1, "pos": [0, 1]}, {"id": 2, "pos": [0, 2], "priority": 0})"),
       "m.json: nodes[1].priority: must be a number in 1e-6 … 1e6, got 0"},
      {WithNodes(R"({"id": 1, "pos": [0, 1], "priority": 2e6})"),
       "m.json: nodes[0].priority: must be a number in 1e-6 … 1e6, got 2000000.0"},
      {WithNodes(R"({"id": 1, "pos": [0, 1], "priority": "high"})"),
       "m.json: nodes[0].priority: must be a number in 1e-6 … 1e6, got \"high\""},
  }));
  CAPTURE(text);
  CHECK(ErrorOf("m.json", text) == message);
}

TEST_CASE("an error in a link or in what holds for the whole file names element, rule and value") {
  const auto [text, message] = GENERATE_COPY(table<std::string, std::string>({
      {WithLinks("5"), "m.json: links[0]: must be an object, got 5"},
      {WithLinks(R"({"target": 7})"), "m.json: links[0]: must have `source`"},
      {WithLinks(R"({"source": 7, "target": "b"}, {"source": 7, "target": 99})"),
       "m.json: links[1].target: no node has the id 99"},
      {WithLinks(R"({"source": 7, "target": "7"})"),
       "m.json: links[0]: the ends must differ, got \"7\""},
      {WithLinks(R"({"source": 7, "target": "b", "length": 0})"),
       "m.json: links[0].length: must be a positive finite number, got 0"},
      {WithLinks(R"({"source": 7, "target": "b", "length": -2.5})"),
       "m.json: links[0].length: must be a positive finite number, got -2.5"},
      {WithLinks(R"({"source": 7, "target": "b", "length": null})"),
       "m.json: links[0].length: must be a positive finite number, got null"},
      {R"({"nodes": [{"id": 0, "pos": [0, 0]}, {"id": 1, "pos": [1, 0]}, {"id": 2, "pos": [2, 0]}],
           "links": [{"source": 0, "target": 1, "length": 1e308},
                     {"source": 1, "target": 2, "length": 1e308}]})",
       "m.json: the sum of the edges' lengths must be finite, got inf"},
      {"{" + kNodes + R"(, "links": [{"source": 7, "target": "b", "length": 1e308}], "graph": {
           "shortest_closed_walk": {"length_m": 5, "source": "", "vertices": [7, "b"]}}})",
       "m.json: shortest_closed_walk.length_m: the walk's edges sum to inf m, got 5"},
      {WithLinks(""), "m.json: a graph must be connected, got no path from vertex 7 to b"},
      {"{" + kNodes + R"(, "links": [], "edges": []})",
       "m.json: the file: must have either `links` or `edges`, got both"},
      {R"({"directed": 1, )" + kNodes + R"(, "links": []})",
       "m.json: directed: must be true or false, got 1"},
      {R"({"directed": true, )" + kNodes + R"(, "links": [{"source": 7, "target": "b"}]})",
       "m.json: links[0]: a directed file must have both arcs of each edge, got none from b to 7"},
      {R"({"directed": true, )" + kNodes +
           R"(, "links": [{"source": 7, "target": "b", "length": 6},
                          {"source": "b", "target": 7, "length": 5}]})",
       "m.json: links[0]: both arcs of an edge must have one length, got 6 and 5"},
      {"{" + kNodes + R"(, "links": [{"source": 7, "target": "b"}], "graph": []})",
       "m.json: graph: must be an object, got a list of 0"},
      {WithGraph(R"("name": 4)"),
       "m.json: graph.name: must be a string of up to 200 bytes without control characters, got 4"},
      {WithGraph(R"("source": "two\nlines")"),
       "m.json: graph.source: must be a string of up to 200 bytes without control characters, got "
       "\"two\\nlines\""},
      {WithGraph(R"("metres_per_px": 0)"),
       "m.json: graph.metres_per_px: must be a positive finite number, got 0"},
      {WithGraph(R"("shortest_closed_walk": {"length_m": 10, "source": ""})"),
       "m.json: graph.shortest_closed_walk: must have `vertices`"},
      {WithGraph(R"("shortest_closed_walk": {"length_m": 10, "source": "", "vertices": [7, "c"]})"),
       "m.json: graph.shortest_closed_walk.vertices[1]: no node has the id \"c\""},
      {WithGraph(R"("shortest_closed_walk": {"length_m": 11, "source": "", "vertices": [7, "b"]})"),
       "m.json: shortest_closed_walk.length_m: the walk's edges sum to 10 m, got 11"},
  }));
  CAPTURE(text);
  CHECK(ErrorOf("m.json", text) == message);
}

TEST_CASE("where lengths come from the file a link must have one") {
  CHECK(ErrorOf("m.json", WithLinks(R"({"source": 7, "target": "b"})"), EdgeLengthSource::kFile) ==
        "m.json: links[0]: must have `length`, since lengths are to come from the file");
}

TEST_CASE("an error in the syntax of JSON names line and column") {
  CHECK_THAT(ErrorOf("m.json", "{\n  \"nodes\": [1,\n    ?]\n}"),
             Catch::Matchers::StartsWith("m.json:3:5: the file must be JSON: "));
  CHECK_THAT(ErrorOf("m.json", ""), Catch::Matchers::StartsWith("m.json:1:1: "));
  CHECK(ErrorOf("m.json", "{\"nodes\": []]") ==
        "m.json:1:13: the file must be JSON: unexpected ']'; expected '}'");
  CHECK(ErrorOf("m.json", R"({"nodes": [{"id": 1, "pos": [1e999, 0]}]})") ==
        "m.json: the file must be JSON with numbers below 1.8e308");
}

TEST_CASE("an error in the syntax of JSON quotes the file shortly and in printable characters") {
  CHECK(ErrorOf("m.json", "\x7f\n") ==
        "m.json:1:1: the file must be JSON: invalid literal; last read: '?'");
  CHECK(ErrorOf("m.json", '"' + std::string(1000, 'a')) ==
        "m.json:1:1002: the file must be JSON: invalid string: missing closing quote; last read: "
        "'\"" +
            std::string(68, 'a') + "…");
}

TEST_CASE("what is no map file is an error that says so") {
  CHECK(ErrorOf("m.txt", "") ==
        "m.txt: the name of a map file must end in .graph or .json, got "
        "'.txt'");
  CHECK_THROWS_WITH(
      ReadGraphFile("/nonexistent/m.json", EdgeLengthSource::kEuclidean, nullptr),
      "/nonexistent/m.json: a map must be a file that can be read, got nothing there");
}

TEST_CASE("a written map reads back to the same graph and the same text") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 6));
  CAPTURE(seed);
  GraphData data = testing::RandomGraphData(12, 8, seed);
  data.name = "round \"trip\"";
  data.source = "test";
  data.metres_per_px = 0.1;
  data.vertex_ids[3] = "door";
  data.vertex_ids[4] = "007";
  data.edges[2].length_m *= 2.0;
  const PatrolGraph graph(data);
  const MapFile file("m.json", "");

  WriteNodeLink(graph, file.path());
  const PatrolGraph sut = ReadGraphFile(file.path(), EdgeLengthSource::kEuclidean, nullptr);

  CHECK(sut.name() == graph.name());
  CHECK(sut.source() == graph.source());
  CHECK(sut.metres_per_px() == graph.metres_per_px());
  for (int v = 0; v < graph.vertex_count(); ++v) {
    CHECK(sut.vertex_id(v) == graph.vertex_id(v));
    CHECK(sut.positions()[v].x_m == graph.positions()[v].x_m);
    CHECK(sut.positions()[v].y_m == graph.positions()[v].y_m);
  }
  REQUIRE(sut.edge_count() == graph.edge_count());
  for (int e = 0; e < graph.edge_count(); ++e) {
    CHECK(sut.edges()[e].source == graph.edges()[e].source);
    CHECK(sut.edges()[e].target == graph.edges()[e].target);
    CHECK(sut.edges()[e].length_m == Approx(graph.edges()[e].length_m).epsilon(1e-12));
  }
  const MapFile again("m.json", "");
  WriteNodeLink(sut, again.path());
  std::ifstream first(file.path());
  std::ifstream second(again.path());
  CHECK(std::string(std::istreambuf_iterator<char>(first), {}) ==
        std::string(std::istreambuf_iterator<char>(second), {}));
}

TEST_CASE("an edge shorter than 1 mm keeps its length when it is written") {
  GraphData data = testing::RandomGraphData(2, 0, 1);
  data.positions = {{0.0, 0.0}, {0.0, 0.0005}};
  data.edges[0].length_m = 0.0005;
  const PatrolGraph graph(data);

  const PatrolGraph sut =
      ParseGraphFile(NodeLinkText(graph), "m.json", EdgeLengthSource::kEuclidean, nullptr);

  CHECK(sut.edges()[0].length_m == 0.0005);
}

TEST_CASE("writing where nothing can be written is an error") {
  const PatrolGraph graph(testing::RandomGraphData(3, 0, 1));
  CHECK_THROWS_WITH(WriteNodeLink(graph, "/nonexistent/m.json"),
                    Catch::StartsWith("/nonexistent/m.json: cannot be written"));
}

}  // namespace
}  // namespace ronda
