#pragma once
// Small files read and replaced as a whole. Errors: InputError with path and reason. Thread-safe
// for different paths.
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ronda {

std::string ReadWholeFile(const std::filesystem::path& path);

enum class Sync { kYes, kNo };

/// Readers see the old bytes or the new ones, also after a crash of the machine: writes `path.tmp`,
/// fsync, rename, fsync of the folder. Without the syncs (kNo) such a crash may leave neither. One
/// writer a path.
void WriteWholeFile(const std::filesystem::path& path, std::string_view bytes,
                    Sync sync = Sync::kYes);

/// The last lines of a text file, oldest first; looks at its last 64 KiB only. Empty where it
/// cannot be read.
std::vector<std::string> LastLines(const std::filesystem::path& path, std::size_t count);

}  // namespace ronda
