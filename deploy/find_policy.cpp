#include "deploy/find_policy.h"

#include <fmt/format.h>

#include "common/base/error.h"
#include "common/run/paths.h"

namespace ronda {

std::filesystem::path FindPolicyFile(const std::string& policy) {
  constexpr std::string_view kLatest = "@latest";
  std::error_code error;
  if (std::filesystem::is_regular_file(policy, error)) return policy;
  const bool latest = policy.ends_with(kLatest);
  const std::filesystem::path folder =
      latest ? policy.substr(0, policy.size() - kLatest.size()) : policy;
  if (std::filesystem::is_directory(folder, error)) {
    const auto checkpoints = folder / "checkpoints";
    for (const char* name : {"best.ronda", "latest.ronda"}) {
      if (latest && std::string_view(name) == "best.ronda") continue;
      if (std::filesystem::is_regular_file(checkpoints / name, error)) return checkpoints / name;
    }
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
