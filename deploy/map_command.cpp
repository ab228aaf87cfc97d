#include "deploy/map_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/evaluation/output_file.h"
#include "common/run/paths.h"
#include "common/world/graph_file.h"
#include "common/world/random_graph.h"
#include "deploy/map_facts.h"
#include "deploy/map_show_command.h"
#include "deploy/named_map.h"
#include "deploy/new_file.h"
#include "deploy/seed_rule.h"
#include "deploy/text_table.h"

namespace ronda {
namespace {

using Json = nlohmann::ordered_json;

void WriteJson(const std::string& path, const Json& json) {
  OutputFile file(path);
  file.Write(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  file.Commit();
}

/// In the format that the ending names.
void WriteMap(const PatrolGraph& graph, const std::filesystem::path& path) {
  std::vector<std::string> warnings;
  if (path.extension() == ".json") {
    WriteNodeLink(graph, path);
  } else {
    WriteDotGraph(graph, path, &warnings);
  }
  PrintWarnings(warnings);
  fmt::print("wrote {}: {} vertices, {} edge{}\n", path.string(), graph.vertex_count(),
             graph.edge_count(), graph.edge_count() == 1 ? "" : "s");
}

/// Before the map is made.
void CheckMapFile(const std::filesystem::path& path, bool force) {
  if (path.extension() != ".json" && path.extension() != ".graph") {
    throw UsageError(fmt::format("{}: the name of a map file must end in .graph or .json, got '{}'",
                                 path.string(), path.extension().string()));
  }
  CheckMayWrite(path, force);
}

void List(const std::string& json_path) {
  std::vector<TableRow> rows;
  Json json = Json::array();
  for (const std::string& name : ShippedMaps(MapsFolder())) {
    const MapFacts facts = FactsOf(LoadNamedMap(name, "euclidean"));
    rows.push_back({{facts.name},
                    {std::to_string(facts.vertices)},
                    {std::to_string(facts.edges)},
                    {FormatSize(facts)},
                    {fmt::format("{:.1f} m", facts.closed_walk_m)},
                    {facts.source}});
    json.push_back(FactsAsJson(facts));
  }
  const std::vector<TableColumn> columns{
      {"map"},  {"vertices", Align::kRight},    {"edges", Align::kRight},
      {"size"}, {"closed walk", Align::kRight}, {"source"}};
  if (!json_path.empty()) WriteJson(json_path, json);
  for (const StyledLine& line : TableLines(columns, rows)) {
    fmt::print("{}\n", line.Draw(line.columns(), ViewStyle::kPlain));
  }
}

void AddList(CLI::App& parent) {
  auto json_path = std::make_shared<std::string>();
  CLI::App* command = parent.add_subcommand("list", "the maps that ship");
  command->add_option("--json", *json_path, "write what there is to say of each to this file");
  command->footer("Example:\n  ronda map list");
  command->callback([json_path] { List(*json_path); });
}

struct CheckArguments {
  std::string map;
  std::string length = "euclidean";
  std::string json_path;
};

void Check(const CheckArguments& arguments) {
  std::vector<std::string> warnings;
  const PatrolGraph graph =
      LoadMap(arguments.map, MapsFolder(), ParseEdgeLengthSource(arguments.length), &warnings);
  PrintWarnings(warnings);
  const MapFacts facts = FactsOf(graph);
  if (!arguments.json_path.empty()) {
    Json json = FactsAsJson(facts);
    json["warnings"] = warnings;
    WriteJson(arguments.json_path, json);
  }
  fmt::print("{}", FormatFacts(facts));
}

void AddCheck(CLI::App& parent) {
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = parent.add_subcommand(
      "check", "read a map as training would, and say what it is; status 3 where it is none");
  command->add_option("MAP", arguments->map, kMapHelp)->required();
  AddLengthOption(*command, arguments->length);
  command->add_option("--json", arguments->json_path, "write it to this file, with all warnings");
  command->footer("Example:\n  ronda map check my.graph");
  command->callback([arguments] { Check(*arguments); });
}

struct ConvertArguments {
  std::string in;
  std::string out;
  std::string length = "euclidean";
  bool force = false;
};

void Convert(const ConvertArguments& arguments) {
  CheckMapFile(arguments.out, arguments.force);
  WriteMap(LoadNamedMap(arguments.in, arguments.length), arguments.out);
}

void AddConvert(CLI::App& parent) {
  auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command = parent.add_subcommand(
      "convert", "a map in another format: .graph (ROS patrolling_sim) or .json (NetworkX)");
  command->add_option("IN", arguments->in, kMapHelp)->required();
  command->add_option("OUT", arguments->out, "the file to write, .graph or .json")->required();
  AddLengthOption(*command, arguments->length);
  command->add_flag("--force", arguments->force, "replace a file that is there");
  command->footer("Example:\n  ronda map convert office.graph office.json");
  command->callback([arguments] { Convert(*arguments); });
}

struct RandomArguments {
  RandomGraphOptions options;
  std::string out;
  bool force = false;
};

void Random(const RandomArguments& arguments) {
  const std::filesystem::path out(arguments.out);
  CheckMapFile(out, arguments.force);
  RandomGraphOptions options = arguments.options;
  options.name = out.stem().string();
  WriteMap(RandomGeometricGraph(options), out);
}

void AddRandom(CLI::App& parent) {
  auto arguments = std::make_shared<RandomArguments>();
  RandomGraphOptions& options = arguments->options;
  CLI::App* command = parent.add_subcommand("random", "a random map: connected, no edges cross");
  command->add_option("--vertices", options.vertices, "2 … 10000")
      ->check(CLI::Range(2, PatrolGraph::kMaxVertices))
      ->required();
  command->add_option("--seed", options.seed, "the same seed gives the same map")
      ->check(SeedRule())
      ->required();
  command->add_option("--out", arguments->out, "the file to write, .graph or .json")->required();
  command->add_option("--degree", options.degree, "mean number of neighbours, 2 … 4")
      ->check(CLI::Range(2.0, 4.0))
      ->capture_default_str();
  command->add_option("--edge-m", options.mean_edge_m, "mean length of an edge, 0.01 … 1e6 m")
      ->check(CLI::Range(0.01, 1e6))
      ->capture_default_str();
  command->add_flag("--force", arguments->force, "replace a file that is there");
  command->footer(
      "Where a map is named, random:VERTICES:SEED is such a map without a file.\n"
      "Example:\n  ronda map random --vertices 60 --seed 7 --out office.json");
  command->callback([arguments] { Random(*arguments); });
}

}  // namespace

void AddMapCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("map", "list, check, draw, convert and make maps");
  command->require_subcommand(1);
  command->footer(
      "Example:\n  ronda map check my.graph\nEach explains itself: ronda map COMMAND --help");
  AddList(*command);
  AddCheck(*command);
  AddMapShowCommand(*command);
  AddConvert(*command);
  AddRandom(*command);
}

}  // namespace ronda
