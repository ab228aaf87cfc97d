#include "common/run/config.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "common/base/check.h"
#include "common/base/error.h"
#include "common/base/whole_file.h"
#include "common/run/nearest_name.h"

namespace ronda {
namespace {

std::string ToToml(bool value) { return value ? "true" : "false"; }
std::string ToToml(std::int64_t value) { return fmt::format("{}", value); }
std::string ToToml(double value) {
  const std::string text = fmt::format("{}", value);  // the shortest that reads back to the same
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}
std::string ToToml(const std::string& value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      text += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      text += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    } else {
      text += c;
    }
  }
  return text + '"';
}
template <class Int>
std::string ToToml(const std::vector<Int>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

std::string ToToml(const Config::Value& value) {
  return std::visit(
      []<class T>(const T& kind) {
        if constexpr (std::is_same_v<T, std::monostate>)
          return std::string();
        else
          return ToToml(kind);
      },
      value);
}

/// Both ends included; an end at the type's limit does not limit.
template <class T>
struct Range {
  T least;
  T most;

  bool Contains(T value) const { return least <= value && value <= most; }  // false for nan

  std::string Text() const {
    using Limits = std::numeric_limits<T>;
    const bool from = least > Limits::lowest();  // -inf is below it
    const bool to = most < Limits::max();
    if (from && to) return fmt::format("{} to {}", least, most);
    if (from) return fmt::format("at least {}", least);
    if (to) return fmt::format("at most {}", most);
    return Limits::is_integer ? "any whole number" : "any finite number";
  }
};

std::string OneLine(std::string_view text) {
  std::string line(text);
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20; }, ' ');
  return line;
}

bool IsKeyPart(std::string_view part) {
  return !part.empty() && std::all_of(part.begin(), part.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
}

bool IsDottedKey(std::string_view key) {
  for (std::size_t dot; (dot = key.find('.')) != std::string_view::npos;) {
    if (!IsKeyPart(key.substr(0, dot))) return false;
    key.remove_prefix(dot + 1);
  }
  return IsKeyPart(key);
}

std::string Trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The value of `text` as a table with the one key `v`; nullopt where it is no TOML value.
std::optional<toml::table> ParseValue(const std::string& text) {
  try {
    toml::table table = toml::parse("v = " + text);
    if (table.size() == 1) return table;
  } catch (const toml::parse_error&) {
  }
  return std::nullopt;
}

}  // namespace

struct Config::Reader {
  Config& config;
  std::string name;
  bool has_lines = true;  // else `name` is the whole place

  void ReadTable(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, node] : table) {
      const std::string place = PlaceOf(key.source().begin);
      if (!IsKeyPart(key.str())) {
        throw InputError(fmt::format("{}: {}{}: must be letters, digits, _ and -, got {}", place,
                                     prefix, OneLine(key.str()), ToToml(std::string(key.str()))));
      }
      ReadNode(node, prefix + std::string(key.str()), place);
    }
  }

  void ReadNode(const toml::node& node, const std::string& key, const std::string& place) {
    if (const toml::table* table = node.as_table()) return ReadTable(*table, key + ".");
    std::ostringstream text;
    node.visit([&](const auto& concrete) { text << concrete; });
    Value value = ValueOf(node);
    const bool is_known_kind = !std::holds_alternative<std::monostate>(value);
    const std::string as_toml = is_known_kind ? ToToml(value) : OneLine(text.str());
    config.given_[key] = {std::move(value), as_toml, place};
  }

 private:
  std::string PlaceOf(const toml::source_position& position) const {
    return has_lines ? fmt::format("{}:{}:{}", name, position.line, position.column) : name;
  }

  static Value ValueOf(const toml::node& node) {
    if (const auto* value = node.as_boolean()) return value->get();
    if (const auto* value = node.as_integer()) return value->get();
    if (const auto* value = node.as_floating_point()) return value->get();
    if (const auto* value = node.as_string()) return value->get();
    const toml::array* array = node.as_array();
    if (array == nullptr) return std::monostate{};
    IntList list;
    for (const toml::node& element : *array) {
      const auto* integer = element.as_integer();
      if (integer == nullptr) return std::monostate{};
      list.push_back(integer->get());
    }
    return list;
  }
};

Config Config::FromFile(const std::filesystem::path& path) {
  return FromString(ReadWholeFile(path), path.string());
}

Config Config::FromString(std::string_view text, const std::string& name) {
  Config config;
  try {
    Reader{config, name}.ReadTable(toml::parse(text), "");
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: not TOML: {}", name, begin.line, begin.column,
                                 OneLine(error.description())));
  }
  return config;
}

void Config::Set(const std::string& assignment) {
  const std::string place = "--set " + assignment;
  const auto equals = assignment.find('=');
  const std::string key = Trimmed(assignment.substr(0, equals));
  if (equals == std::string::npos || !IsDottedKey(key)) {
    throw UsageError(place + ": must be KEY=VALUE, as in dqn.batch_size=128");
  }
  const std::string text = Trimmed(assignment.substr(equals + 1));
  const auto parsed = ParseValue(text);
  const bool bare = !text.empty() && std::string("\"'[{").find(text[0]) == std::string::npos;
  if (!parsed && !bare) {
    throw UsageError(place + ": " + key + ": must be a TOML value, got " + ToToml(text));
  }
  const toml::table table = parsed ? *parsed : toml::table{{"v", text}};
  Reader{*this, place, false}.ReadNode(*table.get("v"), key, place);
}

void Config::Override(const std::string& key, Value value, const std::string& option) {
  const std::string text = ToToml(value);
  given_[key] = {std::move(value), text, option};
}

void Config::Refuse(const std::string& key, const std::string& rule) const {
  const Given& given = given_.at(key);
  throw InputError(fmt::format("{}: {}: {}, got {}", given.place, key, rule, given.text));
}

template <class T>
const T* Config::Find(const std::string& key, const std::string& rule) const {
  const auto given = given_.find(key);
  if (given == given_.end()) return nullptr;
  const T* value = std::get_if<T>(&given->second.value);
  if (value == nullptr) Refuse(key, rule);
  return value;
}

void Config::Register(Known known) {
  RONDA_CHECK(IsDottedKey(known.key), "key {}", known.key);
  for (Known& earlier : known_) {
    if (earlier.key != known.key) continue;
    RONDA_CHECK(earlier.default_value == known.default_value && earlier.rule == known.rule,
                "{} was registered as {} ({}), now as {} ({})", known.key, earlier.default_value,
                earlier.rule, known.default_value, known.rule);
    earlier = std::move(known);
    return;
  }
  known_.push_back(std::move(known));
}

std::int64_t Config::GetInt(const std::string& key, std::int64_t default_value, std::int64_t least,
                            std::int64_t most, const std::string& doc) {
  const Range<std::int64_t> range{least, most};
  RONDA_CHECK(range.Contains(default_value), "{} = {}", key, default_value);
  const auto* given = Find<std::int64_t>(key, "must be a whole number");
  const std::int64_t value = given != nullptr ? *given : default_value;
  if (!range.Contains(value)) Refuse(key, "must be " + range.Text());
  Register({key, ToToml(value), ToToml(default_value), range.Text(), doc});
  return value;
}

double Config::GetDouble(const std::string& key, double default_value, double least, double most,
                         const std::string& doc) {
  const Range<double> range{least, most};
  RONDA_CHECK(std::isfinite(default_value) && range.Contains(default_value), "{} = {}", key,
              default_value);
  double value = default_value;
  if (const auto given = given_.find(key); given != given_.end()) {
    const auto* whole = std::get_if<std::int64_t>(&given->second.value);
    value = whole != nullptr ? static_cast<double>(*whole) : *Find<double>(key, "must be a number");
    if (!std::isfinite(value)) Refuse(key, "must be a finite number");
    if (!range.Contains(value)) Refuse(key, "must be " + range.Text());
  }
  Register({key, ToToml(value), ToToml(default_value), range.Text(), doc});
  return value;
}

bool Config::GetBool(const std::string& key, bool default_value, const std::string& doc) {
  const auto* given = Find<bool>(key, "must be true or false");
  const bool value = given != nullptr ? *given : default_value;
  Register({key, ToToml(value), ToToml(default_value), "true or false", doc});
  return value;
}

std::string Config::GetString(const std::string& key, const std::string& default_value,
                              const std::vector<std::string>& allowed, const std::string& doc,
                              const std::string& listed_in) {
  const auto is_allowed = [&](const std::string& text) {
    return allowed.empty() || std::find(allowed.begin(), allowed.end(), text) != allowed.end();
  };
  RONDA_CHECK(is_allowed(default_value), "{} = {}", key, default_value);
  const std::string rule =
      allowed.empty()
          ? "any text"
          : fmt::format("{}{}", allowed.size() > 1 ? "one of " : "", fmt::join(allowed, ", "));
  const auto* given = Find<std::string>(key, allowed.empty() ? "must be text" : "must be " + rule);
  const std::string value = given != nullptr ? *given : default_value;
  if (!is_allowed(value)) Refuse(key, "must be " + rule);
  Register({key, ToToml(value), ToToml(default_value), rule, doc, listed_in});
  return value;
}

std::vector<int> Config::GetIntList(const std::string& key, const std::vector<int>& default_value,
                                    int least, int most, const std::string& doc) {
  const Range<std::int64_t> range{least, most};
  IntList value(default_value.begin(), default_value.end());
  for (const std::int64_t element : value) {
    RONDA_CHECK(range.Contains(element), "{} = {}", key, ToToml(default_value));
  }
  if (const auto* given = Find<IntList>(key, "must be a list of whole numbers")) value = *given;
  for (const std::int64_t element : value) {
    if (!range.Contains(element)) Refuse(key, "each must be " + range.Text());
  }
  Register({key, ToToml(value), ToToml(default_value), "each " + range.Text(), doc});
  return {value.begin(), value.end()};
}

void Config::RejectUnknown() const {
  std::vector<std::string> names;
  for (const Known& known : known_) names.push_back(known.key);
  for (const auto& [key, given] : given_) {
    if (std::find(names.begin(), names.end(), key) != names.end()) continue;
    const bool is_section = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      return name.starts_with(key + ".");
    });
    if (is_section) Refuse(key, "must be a section");
    const auto nearest = NearestName(key, names);
    throw InputError(fmt::format("{}: {}: unknown key{}", given.place, key,
                                 nearest ? "; did you mean " + *nearest + "?" : ""));
  }
}

std::string Config::Resolved() const {
  const auto section_of = [](const Known& known) {
    return known.key.substr(0, std::min(known.key.rfind('.'), known.key.size()));
  };
  const auto is_loose = [](const Known& known) { return known.key.find('.') == std::string::npos; };
  std::vector<std::string> sections{""};  // keys without a section must come first in TOML
  for (const Known& known : known_) {
    const std::string section = is_loose(known) ? "" : section_of(known);
    if (std::find(sections.begin(), sections.end(), section) == sections.end()) {
      sections.push_back(section);
    }
  }
  std::string text;
  for (const std::string& section : sections) {
    if (!section.empty()) text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", section);
    for (const Known& known : known_) {
      if ((is_loose(known) ? "" : section_of(known)) != section) continue;
      const auto name_begin = section.empty() ? 0 : section.size() + 1;
      text +=
          fmt::format("# {} ({}; default {})\n{} = {}\n", OneLine(known.doc), OneLine(known.rule),
                      known.default_value, known.key.substr(name_begin), known.value);
    }
  }
  return text;
}

}  // namespace ronda
