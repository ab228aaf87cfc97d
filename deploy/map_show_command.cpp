#include "deploy/map_show_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/evaluation/map_usage.h"
#include "common/evaluation/output_file.h"
#include "deploy/map_picture.h"
#include "deploy/named_map.h"
#include "deploy/new_file.h"

namespace ronda {
namespace {

struct ShowArguments {
  std::string map;
  std::string svg_path;
  std::string length = "euclidean";
  std::string colour = "plain";
  std::string trace_path;  // empty: none
  bool ids = false;
  bool force = false;

  bool needs_trace() const { return colour == "idleness" || colour == "traffic"; }
};

MapColours ColoursOf(const PatrolGraph& graph, const ShowArguments& arguments) {
  if (arguments.colour == "priority") {
    return {.label = "priority",
            .of_vertices = graph.unweighted() ? std::vector<double>(graph.vertex_count(), 1.0)
                                              : graph.priorities(),
            .of_edges = {}};
  }
  if (!arguments.needs_trace()) return {};
  TraceReader trace(arguments.trace_path, graph, arguments.map);
  MapUsage usage = MeasureUsage(trace, graph);
  if (arguments.colour == "idleness") {
    return {.label = "mean idleness (s)",
            .of_vertices = std::move(usage.mean_idleness_s),
            .of_edges = {}};
  }
  return {.label = "traversals per hour, all robots",
          .of_vertices = {},
          .of_edges = std::move(usage.traversals_per_hour)};
}

void Show(const ShowArguments& arguments) {
  if (arguments.needs_trace() == arguments.trace_path.empty()) {
    throw UsageError(
        "--trace and --colour idleness or traffic go together; write a trace with "
        "ronda evaluate --trace FILE");
  }
  CheckMayWrite(arguments.svg_path, arguments.force);
  OutputFile svg(arguments.svg_path);
  const PatrolGraph graph = LoadNamedMap(arguments.map, arguments.length);
  svg.Write(DrawMap(graph, ColoursOf(graph, arguments),
                    arguments.ids ? ShowIds::kAlways : ShowIds::kWhereLegible));
  svg.Commit();
  fmt::print("wrote {}\n", arguments.svg_path);
}

}  // namespace

void AddMapShowCommand(CLI::App& map) {
  auto arguments = std::make_shared<ShowArguments>();
  CLI::App* command = map.add_subcommand("show", "a map as a picture (SVG)");
  command->add_option("MAP", arguments->map, kMapHelp)->required();
  command->add_option("--svg", arguments->svg_path, "write the picture to this file")->required();
  command
      ->add_option("--colour", arguments->colour,
                   "plain; idleness: of each vertex, mean; traffic: traversals of each edge; "
                   "priority: of each vertex")
      ->check(CLI::IsMember({"plain", "idleness", "traffic", "priority"}))
      ->capture_default_str();
  command->add_option("--trace", arguments->trace_path,
                      "idleness and traffic: what ronda evaluate --trace wrote");
  AddLengthOption(*command, arguments->length);
  command->add_flag("--ids", arguments->ids, "ids also where they are too dense to read");
  command->add_flag("--force", arguments->force, "replace a file that is there");
  command->footer(
      "Example:\n"
      "  ronda evaluate --map cumberland --agents 10 --strategy sebs --trace trace.csv\n"
      "  ronda map show cumberland --svg traffic.svg --colour traffic --trace trace.csv");
  command->callback([arguments] { Show(*arguments); });
}

}  // namespace ronda
