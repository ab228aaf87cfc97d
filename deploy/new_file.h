#pragma once
// Asked before a command writes a file that the user named: nothing is replaced unasked.
#include <filesystem>

namespace ronda {

/// Throws UsageError where `file` is a folder, or is there already and `force` is not given.
void CheckMayWrite(const std::filesystem::path& file, bool force);

}  // namespace ronda
