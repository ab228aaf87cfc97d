#pragma once
// A file that is either whole or refused: an envelope around a payload of bytes.
//
// Layout (little-endian): magic (8 bytes), format version (4), payload size (8), CRC-32 of all
// other bytes (4), payload. Written to a temporary file beside it, synced, renamed over the old
// file and the folder synced, so that a crash leaves the old file or the new one. Errors:
// CheckpointError naming file, rule and value, for what cannot be written or read, is foreign,
// torn, damaged or of a newer version. Reading allocates no more than the file is long. Thread-safe
// for different paths.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace ronda {

/// `magic` names the kind of file, exactly 8 characters; version ≥ 1. Folders are not made.
void WriteCheckedFile(const std::filesystem::path& path, std::string_view magic,
                      std::uint32_t version, std::string_view payload);

struct CheckedFile {
  std::uint32_t version = 0;  // 1 … newest_version
  std::string payload;
};

CheckedFile ReadCheckedFile(const std::filesystem::path& path, std::string_view magic,
                            std::uint32_t newest_version);

}  // namespace ronda
