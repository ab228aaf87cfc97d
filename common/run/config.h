#pragma once
// The configuration of a process: TOML with typed, ranged getters.
//
// A getter returns the value of a dotted key (`dqn.batch_size`), or its default, and registers the
// key; after all getters have run, RejectUnknown refuses what nobody asked for and Resolved prints
// every key with its value. Messages read `file:line:column: key: rule, got value`, or begin with
// `--set key=value` for what came from there. Errors: InputError; UsageError where --set itself is
// malformed. A default that breaks its own range is a bug and aborts. Plain value;
// thread-compatible. Format: TOML 1.0.
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
  using IntList = std::vector<std::int64_t>;
  /// monostate: a kind of value that no key has (a date, a list of texts).
  using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, IntList>;
  /// What a getter registered.
  struct Known {
    std::string key;
    std::string value;  // as TOML
    std::string default_value;
    std::string rule;  // "1 to 65536"
    std::string doc;
    std::string listed_in = {};  // empty: the rule lists what is allowed
  };

  Config() = default;
  static Config FromFile(const std::filesystem::path& path);
  /// `name` stands for the file in messages.
  static Config FromString(std::string_view text, const std::string& name);

  /// Takes one `--set KEY=VALUE`; wins over the file and over what was set before. VALUE is TOML,
  /// and a text that is not (cumberland, maps/a.graph) is taken as a string.
  void Set(const std::string& assignment);
  /// As Set, for what a command-line option of its own gives; `option` begins the messages.
  void Override(const std::string& key, Value value, const std::string& option);

  // `least` and `most` are included; the type's own limits, or an infinity, do not limit.
  std::int64_t GetInt(const std::string& key, std::int64_t default_value, std::int64_t least,
                      std::int64_t most, const std::string& doc);
  /// Whole numbers are taken too; inf and nan never are.
  double GetDouble(const std::string& key, double default_value, double least, double most,
                   const std::string& doc);
  bool GetBool(const std::string& key, bool default_value, const std::string& doc);
  /// `allowed` empty: any text. `listed_in`: where a page of all keys refers to instead of listing
  /// what is allowed.
  std::string GetString(const std::string& key, const std::string& default_value,
                        const std::vector<std::string>& allowed, const std::string& doc,
                        const std::string& listed_in = "");
  /// `least` and `most` hold for each element.
  std::vector<int> GetIntList(const std::string& key, const std::vector<int>& default_value,
                              int least, int most, const std::string& doc);

  /// Whether a file or --set gave the key.
  bool Has(const std::string& key) const { return given_.contains(key); }

  /// Throws for the first key that no getter asked for, and names the nearest one that is known.
  void RejectUnknown() const;

  const std::vector<Known>& known() const { return known_; }  // in the order of registration

  /// All registered keys in their sections, in the order of registration, each below a comment with
  /// its doc, rule and default; reads back to the same values.
  std::string Resolved() const;

 private:
  struct Given {
    Value value;
    std::string text;   // as TOML
    std::string place;  // "config.toml:3:1", "--set dqn.batch_size=0"
  };

  struct Reader;  // TOML → given_; in the source, so that no TOML type shows here

  template <class T>
  const T* Find(const std::string& key, const std::string& rule) const;
  [[noreturn]] void Refuse(const std::string& key, const std::string& rule) const;
  void Register(Known known);

  std::map<std::string, Given> given_;
  std::vector<Known> known_;
};

}  // namespace ronda
