#pragma once
// A policy file in words, and as JSON for programs (keys: docs/policies.md). Pure functions but for
// the file's size.
#include <filesystem>
#include <string>

#include "common/policies/policy_file.h"

namespace ronda {

/// `path` is where `policy` was read from. Facts that are not known are left out.
std::string FormatPolicy(const std::filesystem::path& path, const PolicyFile& policy);

/// A fact that is not known is null.
std::string PolicyAsJson(const std::filesystem::path& path, const PolicyFile& policy);

}  // namespace ronda
