#include "deploy/terminal_text.h"

#include <catch2/catch.hpp>
#include <cwchar>

#include "tests/unit/terminal_columns.h"

namespace ronda {
namespace {

std::string Utf8(char32_t code) {
  const auto byte = [](char32_t bits) { return static_cast<char>(bits); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | code >> 6), byte(0x80 | (code & 0x3F))};
  if (code < 0x10000) {
    return {byte(0xE0 | code >> 12), byte(0x80 | (code >> 6 & 0x3F)), byte(0x80 | (code & 0x3F))};
  }
  return {byte(0xF0 | code >> 18), byte(0x80 | (code >> 12 & 0x3F)),
          byte(0x80 | (code >> 6 & 0x3F)), byte(0x80 | (code & 0x3F))};
}

TEST_CASE("No character takes more columns than are counted for it, by the C library's table") {
  const Utf8Locale locale;
  std::vector<int> wrong;
  for (char32_t code = 0; code <= 0x10FFFF; ++code) {
    if (code >= 0xD800 && code <= 0xDFFF) continue;
    const std::string text = Harmless(Utf8(code));
    if (text == Utf8(code) && ::wcwidth(static_cast<wchar_t>(code)) > DisplayColumns(text)) {
      wrong.push_back(static_cast<int>(code));
    }
  }
  CHECK(wrong.empty());
}

TEST_CASE("Columns are counted, not bytes") {
  CHECK(DisplayColumns("▁▂▃ → …") == 7);
  CHECK(DisplayColumns("巡回") == 4);
  CHECK(DisplayColumns("re\u0301seau") == 6);
  CHECK(DisplayColumns("\x1b[1;32mgreen\x1b[0m") == 5);
}

TEST_CASE("Text is cut to its columns, and never within a character") {
  CHECK(Cut("patrol", 6) == "patrol");
  CHECK(Cut("patrol", 5) == "patr…");
  CHECK(Cut("patrol", 1) == "…");
  CHECK(Cut("patrol", 0).empty());
  CHECK(Cut("巡回路", 4) == "巡…");
  CHECK(Cut("巡回路", 5) == "巡回…");
}

TEST_CASE("Control characters, reversed writing and bytes that are no UTF-8 become harmless") {
  CHECK(Harmless("\x1b[2J\x1b]0;title\x07") == "\uFFFD[2J\uFFFD]0;title\uFFFD");
  CHECK(Harmless("a\tb\nc\rd") == "a b c d");
  CHECK(Harmless(std::string("a\0b", 3)) == "a\uFFFDb");
  CHECK(Harmless("\u009B2J\u202Etxt") == "\uFFFD2J\uFFFDtxt");
  CHECK(Harmless("\x9B"
                 "2J") == "\uFFFD2J");
  CHECK(Harmless("\xC0\x9B") == "\uFFFD\uFFFD");
  CHECK(Harmless("\xE2\x96") == "\uFFFD\uFFFD");
  CHECK(Harmless("réseau 巡回") == "réseau 巡回");
}

TEST_CASE("Lines are parted at their ends") {
  CHECK(HarmlessLines("one\n\nthree\n") == std::vector<std::string>{"one", "", "three"});
  CHECK(HarmlessLines("").empty());
}

TEST_CASE("Each colour is switched off again, also in a line that is cut") {
  StyledLine sut("ab", Colour::kGreen);
  sut.Add("cd").Add("ef", Colour::kRed);

  CHECK(sut.Draw(6, ViewStyle::kColour) == "\x1b[32mab\x1b[0mcd\x1b[31mef\x1b[0m");
  CHECK(sut.Draw(2, ViewStyle::kColour) == "\x1b[32ma\x1b[0m…");
  CHECK(sut.Draw(6, ViewStyle::kPlain) == "abcdef");
}

}  // namespace
}  // namespace ronda
