#pragma once
// Lists of values as an option takes them, already cut at the commas.
//
// A value that comes again is dropped. UsageError that names option, rule and value. Pure.
#include <string>
#include <vector>

namespace ronda {

/// Each text is a whole number, or a range with both ends: "2..12", "2..12:2"; all in
/// least … greatest.
std::vector<int> ParseWholeNumbers(const std::string& option, const std::vector<std::string>& texts,
                                   int least, int greatest);

/// Texts that are not empty.
std::vector<std::string> ParseTexts(const std::string& option,
                                    const std::vector<std::string>& texts);

}  // namespace ronda
