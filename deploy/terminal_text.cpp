#include "deploy/terminal_text.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace ronda {
namespace {

constexpr std::string_view kReplacement = "\uFFFD";
constexpr std::string_view kEllipsis = "…";

struct Character {
  char32_t code = 0;
  std::size_t bytes = 1;
  bool valid = false;
};

/// The first character of text that is not empty (RFC 3629: shortest form, no surrogates).
Character First(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
  char32_t code = lead & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr std::array<char32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kSmallest[bytes] || surrogate || code > 0x10FFFF) return {};
  return {code, bytes, true};
}

struct Range {
  char32_t first;
  char32_t last;
};

template <std::size_t kSize>
bool In(const std::array<Range, kSize>& ranges, char32_t code) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const Range& range) { return code >= range.first && code <= range.last; });
}

// Unicode's categories Cc and those of Cf that end lines or turn the direction of writing.
constexpr std::array<Range, 7> kDriving{{{0x00, 0x1F},
                                         {0x7F, 0x9F},
                                         {0x61C, 0x61C},
                                         {0x200B, 0x200F},
                                         {0x2028, 0x202E},
                                         {0x2060, 0x206F},
                                         {0xFEFF, 0xFEFF}}};
constexpr std::array<Range, 2> kJoining{{{0x300, 0x36F}, {0x20D0, 0x20F0}}};
// Blocks in which Unicode's East_Asian_Width is W or F for some: the whole of each counts two.
constexpr std::array<Range, 13> kWide{{{0x1100, 0x11FF},
                                       {0x231A, 0x23FF},
                                       {0x25FD, 0x27BF},
                                       {0x2B1B, 0x2B55},
                                       {0x2E80, 0xA4CF},
                                       {0xA960, 0xA97F},
                                       {0xAC00, 0xD7FF},
                                       {0xF900, 0xFAFF},
                                       {0xFE00, 0xFE6F},
                                       {0xFF00, 0xFFEF},
                                       {0x16FE0, 0x1B2FF},
                                       {0x1D300, 0x1D37F},
                                       {0x1F000, 0x3FFFF}}};

int ColumnsOf(char32_t code) {
  if (code < 0x300) return 1;
  if (In(kJoining, code)) return 0;
  return In(kWide, code) ? 2 : 1;
}

/// Bytes of the sequence ESC [ digits and ; m that the text begins with; 0: with none.
std::size_t ColourSequence(std::string_view text) {
  if (!text.starts_with("\x1b[")) return 0;
  const std::size_t end = text.find_first_not_of("0123456789;", 2);
  return end != std::string_view::npos && text[end] == 'm' ? end + 1 : 0;
}

/// The longest beginning that takes at most `columns`, in bytes.
std::size_t Fitting(std::string_view text, int columns) {
  std::size_t bytes = 0;
  while (bytes < text.size()) {
    const Character character = First(text.substr(bytes));
    columns -= ColumnsOf(character.code);
    if (columns < 0) break;
    bytes += character.bytes;
  }
  return bytes;
}

std::string_view Sequence(Colour colour) {
  switch (colour) {
    case Colour::kNone:
      return "";
    case Colour::kBold:
      return "\x1b[1m";
    case Colour::kDim:
      return "\x1b[2m";
    case Colour::kGreen:
      return "\x1b[32m";
    case Colour::kYellow:
      return "\x1b[33m";
    case Colour::kRed:
      return "\x1b[31m";
  }
  return "";
}

}  // namespace

std::string Harmless(std::string_view text) {
  std::string harmless;
  harmless.reserve(text.size());
  while (!text.empty()) {
    const Character character = First(text);
    if (text[0] == '\t' || text[0] == '\n' || text[0] == '\r') {
      harmless += ' ';
    } else if (!character.valid || In(kDriving, character.code)) {
      harmless += kReplacement;
    } else {
      harmless += text.substr(0, character.bytes);
    }
    text.remove_prefix(character.bytes);
  }
  return harmless;
}

std::vector<std::string> HarmlessLines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(Harmless(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

int DisplayColumns(std::string_view text) {
  int columns = 0;
  while (!text.empty()) {
    std::size_t bytes = ColourSequence(text);
    if (bytes == 0) {
      const Character character = First(text);
      columns += ColumnsOf(character.code);
      bytes = character.bytes;
    }
    text.remove_prefix(bytes);
  }
  return columns;
}

std::string Cut(std::string_view text, int columns) {
  return StyledLine(text).Draw(columns, ViewStyle::kPlain);
}

StyledLine& StyledLine::Add(std::string_view text, Colour colour) {
  if (!text.empty()) pieces_.push_back({Harmless(text), colour});
  return *this;
}

int StyledLine::columns() const {
  return std::accumulate(pieces_.begin(), pieces_.end(), 0, [](int sum, const Piece& piece) {
    return sum + DisplayColumns(piece.text);
  });
}

std::string StyledLine::Draw(int columns, ViewStyle style) const {
  if (columns <= 0) return "";
  const bool whole = this->columns() <= columns;
  int room = whole ? columns : columns - 1;
  std::string line;
  for (const Piece& piece : pieces_) {
    const std::size_t bytes = Fitting(piece.text, room);
    const std::string_view text = std::string_view(piece.text).substr(0, bytes);
    const bool coloured = style == ViewStyle::kColour && piece.colour != Colour::kNone;
    if (coloured) line += Sequence(piece.colour);
    line += text;
    if (coloured) line += "\x1b[0m";
    if (bytes < piece.text.size()) break;
    room -= DisplayColumns(text);
  }
  return whole ? line : line + std::string(kEllipsis);
}

}  // namespace ronda
