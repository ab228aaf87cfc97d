#include "common/base/checked_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "common/base/check.h"
#include "common/base/error.h"
#include "common/base/file_descriptor.h"
#include "common/base/whole_file.h"

namespace ronda {
namespace {

constexpr std::size_t kMagicSize = 8;
constexpr std::size_t kVersionAt = kMagicSize;
constexpr std::size_t kSizeAt = kVersionAt + 4;
constexpr std::size_t kCrcAt = kSizeAt + 8;
constexpr std::size_t kHeaderSize = kCrcAt + 4;

[[noreturn]] void Refuse(const std::filesystem::path& path, const std::string& why) {
  throw CheckpointError(fmt::format("{}: {}", path.string(), why));
}

[[noreturn]] void RefuseErrno(const std::filesystem::path& path, const char* action) {
  Refuse(path, fmt::format("cannot {}: {}", action, std::strerror(errno)));
}

/// The low `count` bytes of `value`, the lowest first.
std::string LittleEndian(std::uint64_t value, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
  return bytes;
}

std::uint64_t FromLittleEndian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;)
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::uint32_t Crc(std::string_view header_before_crc, std::string_view payload) {
  const auto add = [](uLong crc, std::string_view bytes) {
    return crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  };
  return static_cast<std::uint32_t>(add(add(0, header_before_crc), payload));
}

std::string ReadWhole(const std::filesystem::path& path) {
  // Not blocking: a pipe must not make us wait.
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file.is_open()) RefuseErrno(path, "open");
  struct stat status = {};
  if (::fstat(file.number(), &status) != 0) RefuseErrno(path, "inspect");
  if (!S_ISREG(status.st_mode)) Refuse(path, "not a regular file");
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t count = ::read(file.number(), bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) RefuseErrno(path, "read");
    if (count == 0) break;  // it shrank meanwhile: the size check below sees it
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace

void WriteCheckedFile(const std::filesystem::path& path, std::string_view magic,
                      std::uint32_t version, std::string_view payload) {
  RONDA_CHECK(magic.size() == kMagicSize && version >= 1, "magic \"{}\", version {}", magic,
              version);
  std::string header(magic);
  header += LittleEndian(version, 4);
  header += LittleEndian(payload.size(), 8);
  header += LittleEndian(Crc(header, payload), 4);

  try {
    WriteWholeFile(path, header.append(payload));
  } catch (const InputError& error) {
    throw CheckpointError(error.what());
  }
}

CheckedFile ReadCheckedFile(const std::filesystem::path& path, std::string_view magic,
                            std::uint32_t newest_version) {
  RONDA_CHECK(magic.size() == kMagicSize, "magic \"{}\"", magic);
  std::string bytes = ReadWhole(path);
  const std::string_view view = bytes;
  if (!view.starts_with(magic)) {
    if (magic.starts_with(view)) Refuse(path, fmt::format("torn: {} bytes only", view.size()));
    Refuse(path, fmt::format("not a {} file: its first bytes differ", magic));
  }
  if (view.size() < kHeaderSize)
    Refuse(path, fmt::format("torn: {} bytes, its header alone has {}", view.size(), kHeaderSize));
  const auto version = static_cast<std::uint32_t>(FromLittleEndian(view.substr(kVersionAt, 4)));
  if (version > newest_version)
    Refuse(path, fmt::format("written by a newer ronda: format {}, this one reads up to {}",
                             version, newest_version));
  const std::uint64_t size = FromLittleEndian(view.substr(kSizeAt, 8));
  if (size != view.size() - kHeaderSize)
    Refuse(path, fmt::format("torn: its header announces {} bytes of payload, there are {}", size,
                             view.size() - kHeaderSize));
  const auto expected = static_cast<std::uint32_t>(FromLittleEndian(view.substr(kCrcAt, 4)));
  const std::uint32_t actual = Crc(view.substr(0, kCrcAt), view.substr(kHeaderSize));
  if (actual != expected || version == 0)
    Refuse(path, fmt::format("damaged: checksum {:08x} instead of {:08x}", actual, expected));
  bytes.erase(0, kHeaderSize);
  return {.version = version, .payload = std::move(bytes)};
}

}  // namespace ronda
