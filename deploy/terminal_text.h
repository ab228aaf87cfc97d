#pragma once
// Text as a terminal shows it: how many columns it takes, cut to fit, in colour or not.
//
// Text is UTF-8. Columns are counted from above: never fewer than a terminal takes (two for what
// may be East Asian or an emoji, none for an accent that joins the letter before it), at times one
// more. Pure; O(length).
#include <string>
#include <string_view>
#include <vector>

namespace ronda {

enum class ViewStyle {
  kColour,  // with the escape sequences that set colours (ECMA-48, SGR), and no others
  kPlain,   // without any
};
enum class Colour { kNone, kBold, kDim, kGreen, kYellow, kRed };

/// Text that cannot drive a terminal: tabs and line ends become spaces; other control characters,
/// those that turn the direction of writing, and bytes that are no UTF-8 become "�".
std::string Harmless(std::string_view text);
/// Each line of a text, harmless; a line end at its end begins no further line.
std::vector<std::string> HarmlessLines(std::string_view text);

/// Sequences that set colours take none.
int DisplayColumns(std::string_view text);

/// At most `columns` of harmless text, with "…" at the end where something went.
std::string Cut(std::string_view text, int columns);

/// One line in pieces, each in its colour. All that comes in is made harmless.
class StyledLine {
 public:
  StyledLine() = default;
  explicit StyledLine(std::string_view text, Colour colour = Colour::kNone) { Add(text, colour); }

  StyledLine& Add(std::string_view text, Colour colour = Colour::kNone);
  bool empty() const { return pieces_.empty(); }
  int columns() const;
  /// At most `columns`, with "…" at the end where something went; each colour is switched off
  /// again.
  std::string Draw(int columns, ViewStyle style) const;

 private:
  struct Piece {
    std::string text;
    Colour colour;
  };
  std::vector<Piece> pieces_;
};

}  // namespace ronda
