#pragma once
// Text of a file as an error shows it: short, and without what a terminal would obey.
#include <string>
#include <string_view>

namespace ronda {

/// The first `most_bytes`, with … where there are more; what is not printable ASCII becomes `?`.
inline std::string ShownText(std::string_view text, std::size_t most_bytes) {
  std::string shown;
  for (const char c : text.substr(0, most_bytes)) shown += c >= ' ' && c <= '~' ? c : '?';
  return text.size() > most_bytes ? shown + "…" : shown;
}

}  // namespace ronda
