#include "common/base/checked_file.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <string>

#include "common/base/bounded_archive.h"
#include "common/base/error.h"
#include "tests/temporary_folder.h"

namespace ronda {
namespace {

using Catch::Matchers::Contains;

constexpr std::string_view kMagic = "RONDATST";

std::string ReadBytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void WriteBytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

TEST_CASE("A checked file gives back the bytes and the version that were written") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "file";
  std::string payload = "payload";
  payload.push_back('\0');
  payload += "\xFF\n";
  for (const std::string& bytes : {payload, std::string()}) {
    WriteCheckedFile(path, kMagic, 3, bytes);
    const CheckedFile sut = ReadCheckedFile(path, kMagic, 3);
    CHECK(sut.payload == bytes);
    CHECK(sut.version == 3);
  }
}

TEST_CASE("A checked file's bytes are the documented layout") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "file";
  WriteCheckedFile(path, kMagic, 2, "abc");
  const std::string head("RONDATST\2\0\0\0\3\0\0\0\0\0\0\0", 20);
  const std::string crc("\xF8\xA2\xE9\x2A", 4);  // CRC-32 of head and payload, little-endian
  CHECK(ReadBytes(path) == head + crc + "abc");
}

TEST_CASE("A checked file with any byte changed, cut or added is refused") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "file";
  WriteCheckedFile(path, kMagic, 1, "some payload");
  const std::string whole = ReadBytes(path);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (const int flip : {0x01, 0x80, 0xFF}) {
      std::string changed = whole;
      changed[i] = static_cast<char>(changed[i] ^ flip);
      WriteBytes(path, changed);
      INFO("byte " << i << " flipped by " << flip);
      CHECK_THROWS_AS(ReadCheckedFile(path, kMagic, 9), CheckpointError);
    }
    WriteBytes(path, whole.substr(0, i));
    INFO("cut after " << i << " bytes");
    CHECK_THROWS_AS(ReadCheckedFile(path, kMagic, 9), CheckpointError);
  }
  WriteBytes(path, whole + "x");
  CHECK_THROWS_AS(ReadCheckedFile(path, kMagic, 9), CheckpointError);
  WriteBytes(path, whole);
  CHECK_NOTHROW(ReadCheckedFile(path, kMagic, 9));
}

TEST_CASE("A refusal names the file and what is wrong with it") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "file";
  CHECK_THROWS_WITH(ReadCheckedFile(path, kMagic, 1),
                    Contains(path.string()) && Contains("cannot open"));
  CHECK_THROWS_WITH(ReadCheckedFile(folder.path(), kMagic, 1), Contains("not a regular file"));
  WriteCheckedFile(path, kMagic, 2, "abc");
  CHECK_THROWS_WITH(ReadCheckedFile(path, kMagic, 1),
                    Contains("written by a newer ronda: format 2, this one reads up to 1"));
  CHECK_THROWS_WITH(ReadCheckedFile(path, "OTHERFIL", 2), Contains("not a OTHERFIL file"));
  const std::string whole = ReadBytes(path);
  WriteBytes(path, whole.substr(0, whole.size() - 1));
  CHECK_THROWS_WITH(ReadCheckedFile(path, kMagic, 2),
                    Contains("announces 3 bytes of payload, there are 2"));
  WriteBytes(path, whole.substr(0, 5));
  CHECK_THROWS_WITH(ReadCheckedFile(path, kMagic, 2), Contains("torn: 5 bytes"));
}

TEST_CASE("A pipe in place of a checked file is refused and not waited for") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "pipe";
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  CHECK_THROWS_AS(ReadCheckedFile(path, kMagic, 1), CheckpointError);
}

TEST_CASE("Writing replaces the old file as a whole and leaves nothing else behind") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "file";
  WriteCheckedFile(path, kMagic, 1, "a long old payload");
  WriteCheckedFile(path, kMagic, 1, "new");
  CHECK(ReadCheckedFile(path, kMagic, 1).payload == "new");
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("A file that cannot be written is an error that names it") {
  const TemporaryFolder folder;
  const auto missing = folder.path() / "missing" / "file";
  CHECK_THROWS_AS(WriteCheckedFile(missing, kMagic, 1, ""), CheckpointError);
  CHECK_THROWS_WITH(WriteCheckedFile(missing, kMagic, 1, ""), Contains(missing.string()));
  const auto taken = folder.path() / "folder";
  std::filesystem::create_directories(taken / "inside");
  CHECK_THROWS_AS(WriteCheckedFile(taken, kMagic, 1, ""), CheckpointError);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("An archive gives back what was put") {
  BoundedOutput out;
  out.Put(std::uint64_t{0xFFFFFFFFFFFFFFFF});
  out.Put(std::string("text"));
  out.Put(std::vector<float>{1.5f, -2.0f});
  out.Put(std::vector<float>{});
  BoundedInput sut(out.Bytes());
  std::uint64_t number = 0;
  std::string text;
  std::vector<float> values, none{1.0f};
  sut.Get(number);
  sut.Get(text);
  sut.Get(values);
  sut.Get(none);
  CHECK(number == 0xFFFFFFFFFFFFFFFF);
  CHECK(text == "text");
  CHECK(values == std::vector<float>{1.5f, -2.0f});
  CHECK(none.empty());
  CHECK(sut.Left() == 0);
}

TEST_CASE("An archive's length that exceeds what is left is refused before it is allocated") {
  for (const std::uint64_t length :
       {std::uint64_t{1}, std::uint64_t{1} << 40, ~std::uint64_t{0}, std::uint64_t{1} << 62}) {
    BoundedOutput out;
    out.Put(length);
    BoundedInput floats(out.Bytes()), text(out.Bytes());
    std::vector<float> values;
    std::string string;
    CHECK_THROWS_WITH(floats.Get(values), Contains("a length exceeds"));
    CHECK_THROWS_WITH(text.Get(string), Contains("a length exceeds"));
  }
}

TEST_CASE("An archive that ends too early is refused") {
  BoundedOutput out;
  out.Put(std::uint8_t{1});
  BoundedInput sut(out.Bytes());
  std::uint64_t number = 0;
  CHECK_THROWS_WITH(sut.Get(number), Contains("ends too early"));
}

}  // namespace
}  // namespace ronda
