#pragma once
// How many actors a run should have: a number in the file `actors` of its folder.
//
// The launcher writes its own number there when it starts, and follows what it finds there while it
// runs; `ronda scale` writes it. Errors: InputError with file, rule and value.
#include <filesystem>

namespace ronda {

void WriteWantedActors(const std::filesystem::path& run_folder, int actors);
int ReadWantedActors(const std::filesystem::path& run_folder);

}  // namespace ronda
