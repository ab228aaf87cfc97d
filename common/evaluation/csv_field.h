#pragma once
// A text as a field of CSV (RFC 4180): in quotes where it contains a separator, a quote or a line
// end. Pure.
#include <string>

namespace ronda {

std::string CsvField(const std::string& text);

}  // namespace ronda
