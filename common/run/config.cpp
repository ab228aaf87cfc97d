#include "common/run/config.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <sstream>

#include "common/base/check.h"
#include "common/base/error.h"

namespace ronda {
namespace {

std::string Quoted(const std::string& text) {
  std::ostringstream out;
  out << toml::value<std::string>(text);
  return out.str();
}

std::string AsToml(const Config::Value& value) {
  struct Printer {
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t i) const { return fmt::format("{}", i); }
    std::string operator()(double d) const {
      const std::string text = fmt::format("{}", d);
      return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
    }
    std::string operator()(const std::string& s) const { return Quoted(s); }
    std::string operator()(const std::vector<std::int64_t>& list) const {
      return fmt::format("[{}]", fmt::join(list, ", "));
    }
  };
  return std::visit(Printer{}, value);
}

/// Number of single-character edits between two words (Levenshtein 1966).
std::size_t EditDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

std::optional<Config::Value> ValueOf(const toml::node& node) {
  if (const auto* b = node.as_boolean()) return b->get();
  if (const auto* i = node.as_integer()) return i->get();
  if (const auto* d = node.as_floating_point()) return d->get();
  if (const auto* s = node.as_string()) return s->get();
  const auto* array = node.as_array();
  if (array == nullptr) return std::nullopt;
  std::vector<std::int64_t> list;
  for (const auto& item : *array) {
    if (!item.is_integer()) return std::nullopt;
    list.push_back(item.as_integer()->get());
  }
  return list;
}

}  // namespace

Config Config::FromFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::error_code error;
  if (!file || std::filesystem::is_directory(path, error)) {
    throw InputError(fmt::format("{}: cannot be opened for reading", path.string()));
  }
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return FromString(text, path.string());
}

Config Config::FromString(std::string_view text, const std::string& name) {
  Config config;
  config.ReadToml(text, name);
  return config;
}

void Config::ReadToml(std::string_view text, const std::string& name) {
  const auto place = [&](const toml::source_region& region) {
    return fmt::format("{}:{}:{}", name, region.begin.line, region.begin.column);
  };
  const auto visit = [&](const auto& self, const toml::table& table,
                         const std::string& prefix) -> void {
    for (const auto& [key, node] : table) {
      const std::string full = prefix + std::string(key.str());
      if (const auto* inner = node.as_table()) {
        self(self, *inner, full + ".");
      } else if (auto value = ValueOf(node)) {
        given_[full] = {std::move(*value), place(node.source())};
      } else {
        throw InputError(fmt::format(
            "{}: {}: a value is a boolean, a number, a string or a list of whole numbers",
            place(node.source()), full));
      }
    }
  };
  try {
    visit(visit, toml::parse(text, name), "");
  } catch (const toml::parse_error& error) {
    throw InputError(
        fmt::format("{}: not valid TOML: {}", place(error.source()), error.description()));
  }
}

void Config::Set(const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError(fmt::format("--set {}: must be KEY=VALUE", assignment));
  }
  const std::string key = assignment.substr(0, equals);
  const std::string text = assignment.substr(equals + 1);
  Value value = text;
  try {
    const auto table = toml::parse("value = " + text);
    const auto parsed = table.size() == 1 ? ValueOf(*table.get("value")) : std::nullopt;
    if (parsed) value = *parsed;
  } catch (const toml::parse_error&) {
    // A bare word: the text as it is.
  }
  given_[key] = {std::move(value), "--set " + assignment};
}

void Config::Override(const std::string& key, Value value, const std::string& option) {
  given_[key] = {std::move(value), option};
}

void Config::Refuse(const std::string& key, const std::string& rule) const {
  const Given& given = given_.at(key);
  throw InputError(fmt::format("{}: {}: {}, got {}", given.place, key, rule, AsToml(given.value)));
}

template <class T>
const T* Config::Find(const std::string& key, const char* rule) const {
  const auto found = given_.find(key);
  if (found == given_.end()) return nullptr;
  const T* value = std::get_if<T>(&found->second.value);
  if (value == nullptr) Refuse(key, rule);
  return value;
}

std::int64_t Config::GetInt(const std::string& key, std::int64_t fallback, std::int64_t least,
                            std::int64_t most, const std::string& doc) {
  const auto rule = fmt::format("must be a whole number from {} to {}", least, most);
  const auto* given = Find<std::int64_t>(key, rule.c_str());
  const std::int64_t value = given != nullptr ? *given : fallback;
  if (value < least || value > most) Refuse(key, rule);
  known_[key] = {value, doc};
  return value;
}

double Config::GetDouble(const std::string& key, double fallback, double least, double most,
                         const std::string& doc) {
  const auto rule = std::isinf(most) ? fmt::format("must be a finite number of at least {}", least)
                                     : fmt::format("must be a number from {} to {}", least, most);
  double value = fallback;
  if (const auto found = given_.find(key); found != given_.end()) {
    if (const auto* whole = std::get_if<std::int64_t>(&found->second.value)) {
      value = static_cast<double>(*whole);
    } else {
      value = *Find<double>(key, rule.c_str());
    }
    if (!std::isfinite(value) || value < least || value > most) Refuse(key, rule);
  }
  known_[key] = {value, doc};
  return value;
}

bool Config::GetBool(const std::string& key, bool fallback, const std::string& doc) {
  const auto* given = Find<bool>(key, "must be true or false");
  const bool value = given != nullptr ? *given : fallback;
  known_[key] = {value, doc};
  return value;
}

std::string Config::GetString(const std::string& key, const std::string& fallback,
                              const std::vector<std::string>& allowed, const std::string& doc) {
  const auto rule = allowed.empty() ? std::string("must be a string")
                                    : fmt::format("must be one of {}", fmt::join(allowed, ", "));
  const auto* given = Find<std::string>(key, rule.c_str());
  const std::string value = given != nullptr ? *given : fallback;
  if (!allowed.empty() && std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
    Refuse(key, rule);
  }
  known_[key] = {value, doc};
  return value;
}

std::vector<int> Config::GetIntList(const std::string& key, const std::vector<int>& fallback,
                                    int least, int most, const std::string& doc) {
  const auto rule = fmt::format("must be a list of whole numbers from {} to {}", least, most);
  std::vector<std::int64_t> wide(fallback.begin(), fallback.end());
  if (const auto* given = Find<std::vector<std::int64_t>>(key, rule.c_str())) {
    wide = *given;
    for (const std::int64_t item : wide) {
      if (item < least || item > most) Refuse(key, rule);
    }
  }
  known_[key] = {wide, doc};
  return {wide.begin(), wide.end()};
}

void Config::RejectUnknown() const {
  for (const auto& [key, given] : given_) {
    if (known_.contains(key)) continue;
    const std::string* nearest = nullptr;
    std::size_t nearest_edits = std::numeric_limits<std::size_t>::max();
    for (const auto& entry : known_) {
      const std::size_t edits = EditDistance(key, entry.first);
      if (edits < nearest_edits) {
        nearest_edits = edits;
        nearest = &entry.first;
      }
    }
    throw InputError(fmt::format(
        "{}: {}: unknown key{}", given.place, key,
        nearest != nullptr ? fmt::format("; did you mean {}?", *nearest) : std::string()));
  }
}

std::string Config::Resolved() const {
  std::string text;
  std::string section;
  for (const auto& [key, known] : known_) {
    const auto dot = key.rfind('.');
    RONDA_CHECK(dot != std::string::npos, "{} has no section", key);
    if (key.substr(0, dot) != section) {
      section = key.substr(0, dot);
      text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", section);
    }
    text += fmt::format("# {}\n{} = {}\n", known.doc, key.substr(dot + 1), AsToml(known.value));
  }
  return text;
}

}  // namespace ronda
