#include <catch2/catch.hpp>
#include <cmath>

#include "common/world/closed_walk.h"
#include "tests/unit/graph/graphs.h"

namespace ronda {
namespace {

struct MapFacts {
  std::string name;
  int vertices = 0;
  int edges = 0;
  double metres_per_px = 1.0;
  double mean_edge_px = 0.0;
  double closed_walk_px = 0.0;
};

TEST_CASE("a shipped map has the size, scale, lengths and closed walk that docs/maps.md states") {
  const MapFacts facts = GENERATE(values<MapFacts>({
      {"4nodes", 4, 5, 1.0, 35.43, 130.0},
      {"cumberland", 40, 44, 0.075, 73.55, 4977.5},
      {"grid", 25, 40, 0.075, 76.0, 1976.0},
      {"milwaukee", 40, 56, 1.0, 109.62, 5872.8},
  }));
  CAPTURE(facts.name);

  const PatrolGraph sut = testing::ShippedMap(facts.name);

  CHECK(sut.name() == facts.name);
  CHECK_FALSE(sut.source().empty());
  CHECK(sut.vertex_count() == facts.vertices);
  CHECK(sut.edge_count() == facts.edges);
  CHECK(sut.metres_per_px() == facts.metres_per_px);
  CHECK(std::abs(sut.mean_edge_length_m() / sut.metres_per_px() - facts.mean_edge_px) < 0.01);
  REQUIRE(sut.shortest_closed_walk());
  CHECK(std::abs(sut.shortest_closed_walk()->length_m / sut.metres_per_px() -
                 facts.closed_walk_px) < 0.05);
  CHECK(ClosedWalkOf(sut, ShortestPaths(sut)).source == sut.shortest_closed_walk()->source);
}

TEST_CASE("a map is loaded by its shipped name or by its path") {
  const std::string maps_dir = std::string(RONDA_SOURCE_DIR) + "/maps";
  CHECK(LoadMap("grid", maps_dir, EdgeLengthSource::kEuclidean, nullptr).edge_count() == 40);
  CHECK(LoadMap(maps_dir + "/grid.json", "", EdgeLengthSource::kEuclidean, nullptr).edge_count() ==
        40);
}

TEST_CASE("a map's name that is not shipped is an error that lists those that are") {
  CHECK_THROWS_WITH(testing::ShippedMap("gird"),
                    "a map must be a .graph or .json file, random:VERTICES:SEED or one of the maps "
                    "in " RONDA_SOURCE_DIR
                    "/maps (4nodes, cumberland, grid, milwaukee), got 'gird'");
}

}  // namespace
}  // namespace ronda
