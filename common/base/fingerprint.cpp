#include "common/base/fingerprint.h"

#include <fmt/format.h>
#include <zlib.h>

#include "common/base/whole_file.h"

namespace ronda {

std::string FileFingerprint(const std::filesystem::path& path) {
  const std::string bytes = ReadWholeFile(path);
  const uLong crc = crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  return fmt::format("{:08x}-{}", crc, bytes.size());
}

}  // namespace ronda
