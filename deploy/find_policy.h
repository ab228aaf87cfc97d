#pragma once
// What `--policy` names: a policy file; a run folder (its best policy; `DIR@latest` its latest); or
// the name of a policy that ships. InputError where there is none.
#include <filesystem>
#include <string>

namespace ronda {

std::filesystem::path FindPolicyFile(const std::string& policy);

}  // namespace ronda
