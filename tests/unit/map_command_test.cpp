// `ronda map` as a user meets it.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "common/base/whole_file.h"
#include "tests/temporary_folder.h"
#include "tests/unit/ronda_program.h"

namespace ronda {
namespace {

using Catch::Contains;
using testing::Ronda;
using testing::Shell;

const std::string kGrid = RONDA_SOURCE_DIR "/maps/grid.json";

nlohmann::json Json(const std::filesystem::path& path) {
  return nlohmann::json::parse(ReadWholeFile(path));
}

/// Each link as its two ends, ascending: NetworkX may turn them round.
std::set<std::pair<int, int>> LinksOf(const std::filesystem::path& path) {
  std::set<std::pair<int, int>> links;
  for (const auto& link : Json(path)["links"]) {
    links.insert(std::minmax<int>({link["source"], link["target"]}));
  }
  return links;
}

bool IsEmpty(const TemporaryFolder& folder) { return std::filesystem::is_empty(folder.path()); }

TEST_CASE("map list names the maps that ship, as text and as JSON") {
  const TemporaryFolder folder;
  const auto result = Ronda("map list --json " + (folder / "l.json").string());
  CHECK(result.status == 0);
  for (const char* part : {"4nodes", "cumberland", "grid", "milwaukee", "22.8 × 22.8 m", "373.3 m",
                           "ROS patrolling_sim"}) {
    CHECK_THAT(result.output, Contains(part));
  }
  const auto json = Json(folder / "l.json");
  REQUIRE(json.size() == 4);
  CHECK(json[1]["name"] == "cumberland");
  CHECK(json[1]["vertices"] == 40);
}

TEST_CASE("map check says what a map is") {
  const TemporaryFolder folder;
  const auto result = Ronda("map check " + kGrid + " --json " + (folder / "c.json").string());

  CHECK(result.status == 0);
  for (const char* part :
       {"25, 0 of them leaves", "40, 228 m in all", "2 … 4, mean 3.2", "5.7 … 5.7, mean 5.7 m",
        "45.6 m", "0.075 m per px", "148.2 m: 2-opt", "all alike"}) {
    CHECK_THAT(result.output, Contains(part));
  }
  const auto json = Json(folder / "c.json");
  CHECK(json["edges"] == 40);
  CHECK(json["degree"]["mean"] == 3.2);
  CHECK(json["total_m"].get<double>() == Approx(228.0));
  CHECK(json["diameter_m"].get<double>() == Approx(45.6));
  CHECK(json["bounding_box_m"]["max"][0].get<double>() -
            json["bounding_box_m"]["min"][0].get<double>() ==
        Approx(22.8));
  CHECK(json["shortest_closed_walk"]["length_m"].get<double>() == Approx(148.2));
  CHECK(json["priority"]["max"] == 1.0);
  CHECK(json["warnings"].empty());
}

TEST_CASE("map check prints warnings and ends well, and ends with 3 where a file is no map") {
  const TemporaryFolder folder;
  std::ofstream(folder / "odd.graph") << "2 9 9 1 0 0  0 0 0 1 1 E 5  1 5 0 0\n";
  const auto odd = Ronda("map check " + (folder / "odd.graph").string());
  CHECK(odd.status == 0);
  CHECK_THAT(odd.output, Contains("warning: ") && Contains("odd.graph:1: the arc from 0 to 1"));

  std::ofstream(folder / "bad.graph") << "2 9 9 1 0 0\n0 0 0 1 7 E 5\n";
  const auto bad = Ronda("map check " + (folder / "bad.graph").string() + " --json " +
                         (folder / "b.json").string());
  CHECK(bad.status == 3);
  CHECK_THAT(bad.output, Contains("bad.graph:2: vertex 0: a neighbour's id must be an integer in "
                                  "0 … 1, got '7'"));
  CHECK_FALSE(std::filesystem::exists(folder / "b.json"));
}

TEST_CASE("map check tells the priorities of a map, and convert keeps them in JSON") {
  const TemporaryFolder folder;
  std::ofstream(folder / "p.json")
      << R"({"nodes": [{"id": 0, "pos": [0, 0], "priority": 5}, {"id": 1, "pos": [3, 4]}],
             "links": [{"source": 0, "target": 1}]})";
  const std::string map = (folder / "p.json").string();
  CHECK_THAT(Ronda("map check " + map).output, Contains("1 … 5, mean 3"));
  CHECK(Ronda("map convert " + map + " " + (folder / "q.json").string()).status == 0);
  CHECK(Json(folder / "q.json")["nodes"][0]["priority"] == 5.0);
  CHECK_THAT(Ronda("map convert " + map + " " + (folder / "q.graph").string()).output,
             Contains("priorities of the vertices are lost"));
}

TEST_CASE("map convert goes to .graph and back, and says what is lost") {
  const TemporaryFolder folder;
  const std::string dot = (folder / "g.graph").string();
  const std::string json = (folder / "g.json").string();

  const auto there = Ronda("map convert " + kGrid + " " + dot);
  CHECK(there.status == 0);
  CHECK_THAT(there.output, Contains("wrote " + dot + ": 25 vertices, 40 edges") &&
                               Contains("shortest closed walk"));
  CHECK(Ronda("map convert --length file " + dot + " " + json).status == 0);
  CHECK(Json(json)["links"] == Json(kGrid)["links"]);
  CHECK(Json(json)["graph"]["metres_per_px"] == 0.075);
}

TEST_CASE("NetworkX opens what map convert writes, and what it writes gives the same map") {
  const TemporaryFolder folder;
  const std::string map = GENERATE("4nodes", "cumberland", "random:60:3");
  const std::string ours = (folder / "m.json").string();
  const std::string theirs = (folder / "nx.json").string();
  const std::string back = (folder / "back.json").string();
  REQUIRE(Ronda("map convert " + map + " " + ours).status == 0);

  const auto opened =
      Shell("/usr/bin/python3 " RONDA_SOURCE_DIR "/tests/unit/networkx_round_trip.py " + ours +
            " " + theirs);

  CAPTURE(opened.output);
  REQUIRE(opened.status == 0);
  const auto json = Json(ours);
  CHECK_THAT(opened.output,
             Contains("Graph, " + std::to_string(json["nodes"].size()) + " nodes, " +
                      std::to_string(json["links"].size()) + " edges, connected: True"));
  CHECK(Ronda("map convert " + theirs + " " + back).status == 0);
  CHECK(Json(back)["nodes"] == json["nodes"]);
  CHECK(LinksOf(back) == LinksOf(ours));
  CHECK(Json(back)["graph"] == json["graph"]);
}

TEST_CASE("map convert, random and show replace nothing unasked") {
  const TemporaryFolder folder;
  const auto [start, file, part] = GENERATE(table<std::string, std::string, std::string>(
      {{"map convert grid ", "m.json", "\"links\""},
       {"map random --vertices 9 --seed 1 --out ", "m.graph", "\n8\n"},
       {"map show grid --svg ", "m.svg", "</svg>"}}));
  const std::string out = (folder / file).string();
  std::ofstream(out) << "mine";
  const std::string command = start + out;

  const auto refused = Ronda(command);
  CHECK(refused.status == 2);
  CHECK_THAT(refused.output, Contains(out + ": is there already; --force replaces it"));
  CHECK(ReadWholeFile(out) == "mine");

  CHECK(Ronda(command + " --force").status == 0);
  CHECK_THAT(ReadWholeFile(out), Contains(part));
}

TEST_CASE("a map whose file has a name that is no UTF-8 is checked and converted all the same") {
  const TemporaryFolder folder;
  const std::string map = (folder / "a\xff.graph").string();
  REQUIRE(Ronda("map convert 4nodes " + map).status == 0);
  const std::string facts = (folder / "facts.json").string();
  const std::string copy = (folder / "copy.json").string();

  CHECK(Ronda("map check " + map + " --json " + facts).status == 0);
  CHECK(Ronda("map convert " + map + " " + copy).status == 0);
  CHECK(Json(facts)["name"] == "a\uFFFD");
  CHECK(Json(copy)["graph"]["name"] == "a\uFFFD");
}

TEST_CASE("map convert leaves nothing where it fails") {
  const TemporaryFolder folder;
  const std::string out = (folder / "m.json").string();
  CHECK(Ronda("map convert atlantis " + out).status == 3);
  CHECK(IsEmpty(folder));
  const auto ending = Ronda("map convert grid " + (folder / "m.txt").string());
  CHECK(ending.status == 2);
  CHECK_THAT(ending.output, Contains("must end in .graph or .json, got '.txt'"));
  CHECK(IsEmpty(folder));
  CHECK(Ronda("map convert grid /nowhere/m.json").status == 3);
}

TEST_CASE("map random makes the map that its numbers say, and random:V:SEED is one") {
  const TemporaryFolder folder;
  const std::string out = (folder / "r.json").string();
  CHECK(Ronda("map random --vertices 40 --seed 7 --out " + out).status == 0);
  CHECK(Json(out)["graph"]["name"] == "r");
  CHECK(Json(out)["links"].size() == 50);
  const std::string named = (folder / "named.json").string();
  CHECK(Ronda("map convert random:40:7 " + named).status == 0);
  CHECK(Json(named)["nodes"] == Json(out)["nodes"]);
  CHECK(Json(named)["links"] == Json(out)["links"]);

  const std::string other = (folder / "o.graph").string();
  CHECK(Ronda("map random --vertices 40 --seed 7 --degree 3 --edge-m 2 --out " + other).status ==
        0);
  CHECK_THAT(Ronda("map check " + other).output, Contains("mean 3\n") && Contains("mean 2 m"));
}

TEST_CASE("a random map can be named wherever a map is") {
  const TemporaryFolder folder;
  const std::string compare =
      "compare --map random:9:4,random:9:5 --agents 2 --strategies cr,er "
      "--episodes 2 --out " +
      (folder / "out").string();
  CHECK_THAT(Ronda(compare).output, Contains("random:9:4") && Contains("random:9:5"));
  CHECK(Ronda(compare).status == 0);  // the same comparison again, which is done
  CHECK_THAT(Ronda("bounds --map random:9:4 --agents 2").output, Contains("random:9:4"));
  CHECK_THAT(Ronda("evaluate --map random:9:4 --agents 2 --strategy cr --episodes 1").output,
             Contains("random:9:4"));
  CHECK_THAT(Ronda("train --map random:9:4 --agents 2 --print-config").output,
             Contains("map = \"random:9:4\""));
  CHECK(Ronda("evaluate --map random:9 --agents 2 --strategy cr").status == 3);
}

TEST_CASE("map random refuses numbers out of range with status 2") {
  for (const char* bad : {"--vertices 1 --seed 1", "--vertices 10001 --seed 1", "--vertices 9",
                          "--vertices 9 --seed -1", "--vertices 9 --seed 18446744073709551616",
                          "--vertices 9 --seed 1 --degree 5", "--vertices 9 --seed 1 --edge-m 0"}) {
    CAPTURE(bad);
    CHECK(Ronda(std::string("map random --out /nowhere/m.json ") + bad).status == 2);
  }
}

TEST_CASE("map show draws idleness and traffic of a trace that evaluate wrote") {
  const TemporaryFolder folder;
  const std::string trace = (folder / "t.csv").string();
  REQUIRE(
      Ronda("evaluate --map grid --agents 3 --strategy er --episodes 2 --trace " + trace).status ==
      0);
  const auto [colour, legend] = GENERATE(table<std::string, std::string>(
      {{"idleness", "mean idleness (s)"}, {"traffic", "traversals per hour"}}));
  const std::string svg = (folder / "m.svg").string();

  // By path, though the trace names the map that ships.
  const auto result =
      Ronda("map show " + kGrid + " --colour " + colour + " --trace " + trace + " --svg " + svg);

  CHECK(result.status == 0);
  CHECK_THAT(ReadWholeFile(svg), Contains(legend) && Contains("25 vertices, 40 edges"));
}

TEST_CASE("map show draws plain maps and priorities without a trace") {
  const TemporaryFolder folder;
  const std::string svg = (folder / "m.svg").string();
  CHECK(Ronda("map show cumberland --svg " + svg).status == 0);
  CHECK_THAT(ReadWholeFile(svg), Contains(">39</text>"));
  CHECK(Ronda("map show random:300:1 --colour priority --force --svg " + svg).status == 0);
  CHECK_THAT(ReadWholeFile(svg), Contains(">priority</text>"));
}

TEST_CASE("an edge on a picture has the length that is asked for") {
  const TemporaryFolder folder;
  std::ofstream(folder / "m.graph") << "2 9 9 1 0 0  0 0 0 1 1 E 8  1 5 0 1 0 W 8\n";
  const std::string svg = (folder / "m.svg").string();
  const auto [length, title] = GENERATE(
      table<std::string, std::string>({{"euclidean", "0 - 1, 5 m"}, {"file", "0 - 1, 8 m"}}));

  CHECK(Ronda("map show " + (folder / "m.graph").string() + " --length " + length + " --svg " + svg)
            .status == 0);
  CHECK_THAT(ReadWholeFile(svg), Contains("<title>" + title + "</title>"));
}

TEST_CASE("map show refuses a trace of another map, and what does not go together") {
  const TemporaryFolder folder;
  const std::string trace = (folder / "t.csv").string();
  const std::string svg = (folder / "m.svg").string();
  REQUIRE(
      Ronda("evaluate --map grid --agents 3 --strategy er --episodes 1 --trace " + trace).status ==
      0);

  const auto other =
      Ronda("map show cumberland --colour traffic --trace " + trace + " --svg " + svg);
  CHECK(other.status == 3);
  CHECK_THAT(other.output,
             Contains(trace + ":1: the trace must be of the map 'cumberland', got \"grid\""));
  CHECK_FALSE(std::filesystem::exists(svg));
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);

  CHECK(Ronda("map show grid --colour traffic --svg " + svg).status == 2);
  CHECK(Ronda("map show grid --trace " + trace + " --svg " + svg).status == 2);
  CHECK(Ronda("map show grid").status == 2);
  CHECK(Ronda("map show grid --svg /nowhere/m.svg").status == 2);
}

TEST_CASE("each command of map has an example in its help") {
  for (const char* command : {"", "list", "check", "show", "convert", "random"}) {
    CAPTURE(command);
    const auto result = Ronda(std::string("map ") + command + " --help");
    CHECK(result.status == 0);
    CHECK_THAT(result.output, Contains("Example:\n") && Contains("ronda map ") &&
                                  Contains(std::string("ronda map ") + command));
  }
  CHECK(Ronda("map").status == 2);
}

}  // namespace
}  // namespace ronda
