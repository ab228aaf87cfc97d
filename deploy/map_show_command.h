#pragma once
// `ronda map show`: a map as SVG, coloured by what a trace says of it. Errors as AddMapCommand.
namespace CLI {
class App;
}

namespace ronda {

/// Adds `show` to the command `map`.
void AddMapShowCommand(CLI::App& map);

}  // namespace ronda
