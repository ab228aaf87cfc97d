#include "deploy/find_policy.h"

#include <fmt/format.h>

#include "common/base/error.h"
#include "common/run/paths.h"

namespace ronda {
namespace {

std::optional<std::filesystem::path> Checkpoint(const std::filesystem::path& run_folder,
                                                const char* name) {
  auto file = run_folder / "checkpoints" / name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  return file;
}

std::optional<std::filesystem::path> LatestPolicyOf(const std::filesystem::path& run_folder) {
  return Checkpoint(run_folder, "latest.ronda");
}

}  // namespace

std::optional<std::filesystem::path> PolicyOfRun(const std::filesystem::path& run_folder) {
  const auto best = Checkpoint(run_folder, "best.ronda");
  return best ? best : LatestPolicyOf(run_folder);
}

std::filesystem::path FindPolicyFile(const std::string& policy) {
  constexpr std::string_view kLatest = "@latest";
  std::error_code error;
  if (std::filesystem::is_regular_file(policy, error)) return policy;
  const bool latest = policy.ends_with(kLatest);
  const std::filesystem::path folder =
      latest ? policy.substr(0, policy.size() - kLatest.size()) : policy;
  if (std::filesystem::is_directory(folder, error)) {
    const auto found = latest ? LatestPolicyOf(folder) : PolicyOfRun(folder);
    if (found) return *found;
    throw InputError(fmt::format("{}: this folder holds no trained policy (checkpoints/{}.ronda)",
                                 folder.string(), latest ? "latest" : "best"));
  }
  const auto shipped = PoliciesFolder() / (policy + ".ronda");
  if (std::filesystem::is_regular_file(shipped, error)) return shipped;
  throw InputError(
      fmt::format("no policy '{}': neither a policy file, nor a run folder, nor the name of a "
                  "policy that ships",
                  policy));
}

}  // namespace ronda
