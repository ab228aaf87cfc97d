#pragma once
// The files of a run that are written again and again, and which of them cannot be at present.
//
// A full disk does not end a run: it is said once, and again when writing works again.
// Thread-compatible.
#include <fmt/format.h>

#include <functional>
#include <map>
#include <string>

#include "common/base/error.h"

namespace ronda {

class KeptFiles {
 public:
  /// Calls `write`, which throws Error where it fails. What there is to say about it; empty:
  /// nothing new.
  [[nodiscard]] std::string Write(const std::string& name, const std::function<void()>& write) {
    try {
      write();
      return unwritten_.erase(name) > 0 ? name + " is written again" : "";
    } catch (const Error& error) {
      const bool is_new = unwritten_.insert_or_assign(name, error.what()).second;
      return is_new ? fmt::format("{} is not kept: {}; the run goes on and tries again", name,
                                  error.what())
                    : "";
    }
  }

  const std::map<std::string, std::string>& unwritten() const { return unwritten_; }  // name → why

 private:
  std::map<std::string, std::string> unwritten_;
};

}  // namespace ronda
