#include "common/run/role_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>

#include "common/base/error.h"
#include "common/run/incarnation.h"

namespace ronda {

RoleOptions ParseRoleOptions(const std::string& role, const std::string& purpose, int argc,
                             char** argv) {
  RoleOptions options;
  CLI::App app(purpose, "ronda-" + role);
  app.set_version_flag("--version", "ronda-" + role + " " RONDA_VERSION);
  app.add_option("--config", options.config_file, "a run's resolved config.toml")->required();
  app.add_option("--run", options.run_folder, "the run folder")->required();
  app.add_option("--domain", options.domain, "DDS domain")->required()->check(CLI::Range(0, 232));
  app.add_option("--run-id", options.run_id, "the run's name on the wire")->required();
  app.add_option("--index", options.index, "which of the actors, from 0");
  app.add_option("--incarnation", options.incarnation,
                 "larger for every start; by default from the clock");
  app.add_option("--weights-version", options.weights_version,
                 "the last version of the weights that was seen (learner)");
  app.add_flag("--end-with-parent", options.end_with_parent, "stop when the parent process ends");
  app.footer(
      fmt::format("Example: ronda-{} --config runs/quickstart/config.toml --run runs/quickstart "
                  "--domain 7 --run-id quickstart\n"
                  "`ronda train` starts all processes of a run with the right options.",
                  role));
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    std::exit(app.exit(success));
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  if (options.incarnation == 0) options.incarnation = NewIncarnation();
  return options;
}

}  // namespace ronda
