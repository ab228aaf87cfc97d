#pragma once
// Numbers as colours that the colour-blind tell apart and that survive a grey print: viridis, dark
// for much and light for little.
//
// The ends of a scale are round numbers around the values. Pure. Source: the colour map viridis of
// S. van der Walt and N. Smith (2015, CC0), at eleven points.
#include <string>
#include <vector>

namespace ronda {

/// The largest of … 0.1, 0.2, 0.5, 1, 2, 5 … that is at most `value` > 0.
double RoundBelow(double value);

class ColourScale {
 public:
  /// For finite values from `least` to `most`; begins at 0 where the two are equal.
  ColourScale(double least, double most);

  /// Where a value stands between the ends, 0 … 1.
  double Share(double value) const;
  std::string Colour(double value) const { return ColourAt(Share(value)); }
  /// White is legible on it, and black is not.
  bool IsDark(double value) const { return Share(value) > 0.45; }
  /// Round numbers from end to end, ascending, a few.
  const std::vector<double>& ticks() const { return ticks_; }

  /// "#rrggbb" for a share of 0 … 1.
  static std::string ColourAt(double share);

 private:
  std::vector<double> ticks_;
};

}  // namespace ronda
