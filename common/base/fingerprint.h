#pragma once
// What tells one version of a file from another: the CRC-32 of its bytes and how many they are.
//
// Against accidents, not against forgery. Errors: InputError with path and reason. Thread-safe.
#include <filesystem>
#include <string>

namespace ronda {

/// "cbf43926-9"; the file is read as a whole.
std::string FileFingerprint(const std::filesystem::path& path);

}  // namespace ronda
