#pragma once
// Where Ronda's own files stand. HomeFolder is the environment variable RONDA_HOME, else
// `../share/ronda` from the program's folder where that is there (an installation), else the source
// folder that the program was built from. What is in it need not exist.
#include <filesystem>

namespace ronda {

std::filesystem::path HomeFolder();
std::filesystem::path MapsFolder();
std::filesystem::path PoliciesFolder();

/// The folder of the running executable, where its siblings (ronda-actor, …) are. Linux only.
std::filesystem::path ProgramFolder();

}  // namespace ronda
