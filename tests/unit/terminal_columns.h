#pragma once
// What the C library's own table says about the columns of a text, to compare ours with. The locale
// counts for the thread that made it, until it goes.
#include <clocale>
#include <cstdlib>
#include <cwchar>
#include <string>

#include "common/base/check.h"

namespace ronda {

class Utf8Locale {
 public:
  Utf8Locale() : locale_(::newlocale(LC_ALL_MASK, "C.UTF-8", locale_t{})) {
    RONDA_CHECK(locale_ != locale_t{}, "locale C.UTF-8");
    former_ = ::uselocale(locale_);
  }
  ~Utf8Locale() {
    ::uselocale(former_);
    ::freelocale(locale_);
  }
  Utf8Locale(const Utf8Locale&) = delete;
  Utf8Locale& operator=(const Utf8Locale&) = delete;

  /// -1 where a character cannot be printed.
  int Columns(const std::string& text) const {
    std::wstring wide(text.size() + 1, L'\0');
    const std::size_t count = std::mbstowcs(wide.data(), text.c_str(), wide.size());
    return count == static_cast<std::size_t>(-1) ? -1 : ::wcswidth(wide.c_str(), count);
  }

 private:
  locale_t locale_;
  locale_t former_{};
};

}  // namespace ronda
