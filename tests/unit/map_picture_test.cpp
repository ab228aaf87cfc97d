#include "deploy/map_picture.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "common/world/graph_file.h"
#include "common/world/random_graph.h"
#include "deploy/colour_scale.h"

namespace ronda {
namespace {

PatrolGraph Triangle(const std::string& id = "2") {
  return PatrolGraph({.name = "tri",
                      .vertex_ids = {"0", "1", id},
                      .positions = {{0, 0}, {300, 0}, {0, 100}},
                      .edges = {{0, 1, 300}, {0, 2, 100}, {1, 2, std::hypot(300, 100)}}});
}

int Count(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

struct Circle {
  double x, y;
  std::string fill;
};

std::vector<Circle> Circles(const std::string& svg) {
  const std::regex circle(
      "<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"[0-9.]+\" fill=\"(.*?)\">");
  std::vector<Circle> circles;
  for (std::sregex_iterator match(svg.begin(), svg.end(), circle), end; match != end; ++match) {
    circles.push_back({std::stod((*match)[1]), std::stod((*match)[2]), (*match)[3]});
  }
  return circles;
}

TEST_CASE("A picture has a circle for each vertex, equally scaled, with y to the top") {
  const std::string sut = DrawMap(Triangle(), {}, ShowIds::kWhereLegible);

  const auto at = Circles(sut);
  REQUIRE(at.size() == 3);
  CHECK(at[1].x - at[0].x == Approx(900.0));
  CHECK(at[0].y - at[2].y == Approx(300.0));
  CHECK(at[0].y == at[1].y);
  CHECK(Count(sut, "<line ") == 3);
  CHECK(sut.find(">50 m</text>") != std::string::npos);  // of 60, a fifth of the width
  CHECK(sut.find("3 vertices, 3 edges") != std::string::npos);
  CHECK(sut.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  CHECK(sut.ends_with("</svg>\n"));
}

TEST_CASE("Values of vertices become colours with a legend: the most is darkest") {
  const std::string sut = DrawMap(
      Triangle(), {.label = "mean idleness (s)", .of_vertices = {0.0, 5.0, 10.0}, .of_edges = {}},
      ShowIds::kWhereLegible);

  const auto circles = Circles(sut);
  REQUIRE(circles.size() == 3);
  CHECK(circles[0].fill == "#fde725");
  CHECK(circles[1].fill == "#21908c");
  CHECK(circles[2].fill == "#440154");
  CHECK(sut.find(">mean idleness (s)</text>") != std::string::npos);
  for (const char* tick : {">0</text>", ">2</text>", ">10</text>"}) {
    CHECK(sut.find(tick) != std::string::npos);
  }
  CHECK(sut.find("<title>1: 5</title>") != std::string::npos);
}

TEST_CASE("Values of edges become width and colour, from 0") {
  const std::string sut =
      DrawMap(Triangle(), {.label = "l", .of_vertices = {}, .of_edges = {30.0, 60.0, 45.0}},
              ShowIds::kWhereLegible);

  CHECK(sut.find("stroke=\"#440154\" stroke-width=\"9.0\"><title>0 - 2, 100 m: 60</title>") !=
        std::string::npos);
  CHECK(sut.find("stroke=\"#21908c\"") != std::string::npos);
  CHECK(sut.find(">0</text>") != std::string::npos);
  CHECK(sut.find(" - 2, 100 m: 60") > sut.find("0 - 1, 300 m: 30"));  // the busiest on top
}

TEST_CASE("Ids are left out where they cannot be read, unless they are asked for") {
  const auto ids = [](int vertices, ShowIds show) {
    const std::string svg = DrawMap(RandomGeometricGraph({.vertices = vertices}), {}, show);
    return svg.find(">" + std::to_string(vertices - 1) + "</text>") != std::string::npos;
  };
  CHECK(ids(4, ShowIds::kWhereLegible));
  CHECK(ids(200, ShowIds::kWhereLegible));
  CHECK_FALSE(ids(1000, ShowIds::kWhereLegible));
  CHECK(ids(1000, ShowIds::kAlways));
}

TEST_CASE("Any id is drawn as text, never as markup") {
  const std::string sut =
      DrawMap(Triangle("</text><script>&\"\x01\xff"), {}, ShowIds::kWhereLegible);
  CHECK(sut.find("<script>") == std::string::npos);
  CHECK(Count(sut, "&lt;/text&gt;&lt;script&gt;&amp;\"\uFFFD\uFFFD") >= 2);
  CHECK(sut.find('\x01') == std::string::npos);
}

TEST_CASE("A map on one point or on one line is drawn all the same") {
  const double y_m = GENERATE(0.0, 7.0);
  const PatrolGraph graph({.name = "line",
                           .vertex_ids = {"0", "1"},
                           .positions = {{0, 0}, {0, y_m}},
                           .edges = {{0, 1, 1.0}}});
  const std::string sut = DrawMap(graph, {}, ShowIds::kAlways);
  CHECK(Circles(sut).size() == 2);
  CHECK(sut.find("nan") == std::string::npos);
  CHECK(sut.find("inf") == std::string::npos);
}

TEST_CASE("A scale ends at round numbers around its values") {
  using Ticks = std::vector<double>;
  CHECK(ColourScale(0.0, 10.0).ticks() == Ticks{0, 2, 4, 6, 8, 10});
  CHECK(ColourScale(9.1, 11.8).ticks() == Ticks{9, 9.5, 10, 10.5, 11, 11.5, 12});
  CHECK_THAT(ColourScale(0.0, 0.0).ticks(),
             Catch::Matchers::Approx(Ticks{0, 0.2, 0.4, 0.6, 0.8, 1}));
  CHECK(ColourScale(3.0, 3.0).ticks() == Ticks{0, 1, 2, 3});
  CHECK(ColourScale(1e300, 1e300 * (1.0 + 1e-15)).ticks().size() < 12);
  for (const double most : {1e-6, 0.37, 1.0, 123.0, 9.99e7}) {
    const ColourScale sut(0.1 * most, most);
    CAPTURE(most);
    CHECK(sut.ticks().front() <= 0.1 * most);
    CHECK(sut.ticks().back() >= most * (1.0 - 1e-12));
    CHECK(sut.ticks().size() >= 3);
    CHECK(sut.ticks().size() <= 10);
  }
}

}  // namespace
}  // namespace ronda
