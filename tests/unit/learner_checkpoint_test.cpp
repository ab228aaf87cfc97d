#include <catch2/catch.hpp>
#include <fstream>

#include "common/base/error.h"
#include "learner/checkpoint.h"
#include "tests/temporary_folder.h"

namespace ronda {
namespace {

LearnerCheckpoint Numbered(std::uint64_t updates) {
  LearnerCheckpoint checkpoint;
  checkpoint.algorithm.algorithm = "dqn";
  checkpoint.algorithm.architecture_hash = 77;
  checkpoint.algorithm.updates = updates;
  checkpoint.algorithm.vectors = {{.name = "online", .values = {1.0f, -2.0f, 3.5f}}};
  checkpoint.weights_version = 10 * updates;
  return checkpoint;
}

void Truncate(const std::filesystem::path& path) {
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
}

TEST_CASE("A checkpoint reads back as it was written, and the newest counts") {
  const TemporaryFolder folder;
  std::string note;
  CHECK_FALSE(ReadLearnerCheckpoint(folder.path(), note).has_value());

  WriteLearnerCheckpoint(folder.path(), Numbered(1));
  WriteLearnerCheckpoint(folder.path(), Numbered(2));
  const auto sut = ReadLearnerCheckpoint(folder.path(), note);

  REQUIRE(sut.has_value());
  CHECK(sut->algorithm == Numbered(2).algorithm);
  CHECK(sut->weights_version == 20);
  CHECK(note.empty());
}

TEST_CASE("A torn checkpoint is passed over for the one before, and the note says why") {
  const TemporaryFolder folder;
  WriteLearnerCheckpoint(folder.path(), Numbered(1));
  WriteLearnerCheckpoint(folder.path(), Numbered(2));
  Truncate(folder / "learner.checkpoint");

  std::string note;
  const auto sut = ReadLearnerCheckpoint(folder.path(), note);

  REQUIRE(sut.has_value());
  CHECK(sut->algorithm.updates == 1);
  CHECK(note.find("learner.checkpoint") != std::string::npos);
}

TEST_CASE("Where all checkpoints are torn, reading fails and names the file") {
  const TemporaryFolder folder;
  WriteLearnerCheckpoint(folder.path(), Numbered(1));
  Truncate(folder / "learner.checkpoint");

  std::string note;
  CHECK_THROWS_AS(ReadLearnerCheckpoint(folder.path(), note), CheckpointError);
}

}  // namespace
}  // namespace ronda
