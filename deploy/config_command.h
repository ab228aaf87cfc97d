#pragma once
// `ronda config`: every key of the configuration, as the processes' own getters register it.
//
// The page is Markdown, one table a section: key, default, rule, who reads it, meaning. It is also
// docs/configuration.md, which a test compares.
#include <string>

namespace CLI {
class App;
}

namespace ronda {

std::string ConfigurationPage();

void AddConfigCommand(CLI::App& app);

}  // namespace ronda
