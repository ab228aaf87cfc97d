#pragma once
// Configuration: TOML with typed, ranged getters; every message reads `file:line:column: key: rule,
// got value`.
//
// A getter gives the value of a dotted key, or its default, and registers the key; after all
// getters have run, RejectUnknown refuses keys that nobody asked for, naming the nearest one known,
// and Resolved prints every key with its value. All errors are InputError. A value;
// thread-compatible.
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ronda {

class Config {
 public:
  using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<std::int64_t>>;

  Config() = default;
  static Config FromFile(const std::filesystem::path& path);
  static Config FromString(std::string_view text, const std::string& name);

  /// Takes `KEY=VALUE` (a TOML value; a bare word is a string); wins over what a file said.
  void Set(const std::string& assignment);
  /// As Set, for a value that is known: what a command-line option of its own gives.
  void Override(const std::string& key, Value value, const std::string& option);

  std::int64_t GetInt(const std::string& key, std::int64_t fallback, std::int64_t least,
                      std::int64_t most, const std::string& doc);
  double GetDouble(const std::string& key, double fallback, double least, double most,
                   const std::string& doc);
  bool GetBool(const std::string& key, bool fallback, const std::string& doc);
  /// `allowed` empty: any text.
  std::string GetString(const std::string& key, const std::string& fallback,
                        const std::vector<std::string>& allowed, const std::string& doc);
  std::vector<int> GetIntList(const std::string& key, const std::vector<int>& fallback, int least,
                              int most, const std::string& doc);

  bool Has(const std::string& key) const { return given_.contains(key); }
  void RejectUnknown() const;
  /// All registered keys as TOML, each with its doc as a comment; reads back to the same values.
  std::string Resolved() const;

 private:
  struct Given {
    Value value;
    std::string place;  // "config.toml:3:1", or "--set"
  };
  struct Known {
    Value value;
    std::string doc;
  };

  void ReadToml(std::string_view text, const std::string& name);
  [[noreturn]] void Refuse(const std::string& key, const std::string& rule) const;
  template <class T>
  const T* Find(const std::string& key, const char* rule) const;

  std::map<std::string, Given> given_;
  std::map<std::string, Known> known_;
};

}  // namespace ronda
