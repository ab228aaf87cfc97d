#pragma once
// Where Ronda's own files stand: the environment variable RONDA_HOME, else the source folder that
// it was built from.
#include <filesystem>

namespace ronda {

std::filesystem::path HomeFolder();
inline std::filesystem::path MapsFolder() { return HomeFolder() / "maps"; }
inline std::filesystem::path PoliciesFolder() { return HomeFolder() / "policies"; }
/// The folder of the running program, where its siblings (ronda-actor, …) are.
std::filesystem::path ProgramFolder();

}  // namespace ronda
