#include "learner/checkpoint.h"

#include <fmt/format.h>

#include <cereal/archives/portable_binary.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <sstream>

#include "common/base/checked_file.h"
#include "common/base/error.h"

namespace ronda {

template <class Archive>
void serialize(Archive& archive, AlgorithmState::Vector& vector) {
  archive(vector.name, vector.values);
}

template <class Archive>
void serialize(Archive& archive, AlgorithmState& state) {
  archive(state.algorithm, state.architecture_hash, state.updates, state.optimiser_steps,
          state.progress, state.vectors);
}

template <class Archive>
void serialize(Archive& archive, LearnerCheckpoint& checkpoint) {
  archive(checkpoint.algorithm, checkpoint.weights_version);
}

namespace {

constexpr std::string_view kMagic = "RONDALRN";
constexpr std::uint32_t kVersion = 1;

std::filesystem::path Newest(const std::filesystem::path& folder) {
  return folder / "learner.checkpoint";
}
std::filesystem::path Previous(const std::filesystem::path& folder) {
  return folder / "learner.previous";
}

LearnerCheckpoint Read(const std::filesystem::path& path) {
  std::istringstream stream(ReadCheckedFile(path, kMagic, kVersion).payload);
  LearnerCheckpoint checkpoint;
  try {
    cereal::PortableBinaryInputArchive archive(stream);
    archive(checkpoint);
  } catch (const std::exception& error) {
    throw CheckpointError(
        fmt::format("{}: not a learner's checkpoint: {}", path.string(), error.what()));
  }
  return checkpoint;
}

}  // namespace

void WriteLearnerCheckpoint(const std::filesystem::path& folder,
                            const LearnerCheckpoint& checkpoint) {
  std::ostringstream stream;
  {
    cereal::PortableBinaryOutputArchive archive(stream);
    archive(checkpoint);
  }
  std::error_code error;
  if (std::filesystem::exists(Newest(folder), error)) {
    std::filesystem::rename(Newest(folder), Previous(folder), error);
  }
  WriteCheckedFile(Newest(folder), kMagic, kVersion, stream.view());
}

std::optional<LearnerCheckpoint> ReadLearnerCheckpoint(const std::filesystem::path& folder,
                                                       std::string& note) {
  std::error_code error;
  const bool newest = std::filesystem::exists(Newest(folder), error);
  const bool previous = std::filesystem::exists(Previous(folder), error);
  if (!newest && !previous) return std::nullopt;
  if (newest) {
    try {
      return Read(Newest(folder));
    } catch (const CheckpointError& torn) {
      if (!previous) throw;
      note = torn.what();
    }
  }
  return Read(Previous(folder));
}

}  // namespace ronda
