#include "deploy/colour_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ronda {
namespace {

struct Rgb {
  double red, green, blue;
};

constexpr std::array<Rgb, 11> kViridis{{{68, 1, 84},
                                        {72, 37, 118},
                                        {65, 68, 135},
                                        {53, 96, 141},
                                        {42, 120, 142},
                                        {33, 144, 140},
                                        {34, 168, 132},
                                        {67, 191, 113},
                                        {122, 209, 81},
                                        {187, 223, 39},
                                        {253, 231, 37}}};

}  // namespace

double RoundBelow(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= value) return digit * power;
  }
  return power;
}

ColourScale::ColourScale(double least, double most) {
  constexpr double kNoDifference = 1e-9;
  if (most - least <= kNoDifference * std::abs(most)) least = std::min(least, 0.0);
  if (most == least) most = 1.0;  // both 0
  const double step = RoundBelow((most - least) / 3.0);
  const double first = std::floor(least / step);
  const double pieces = std::ceil(most / step) - first;
  for (int k = 0; k <= static_cast<int>(pieces); ++k) ticks_.push_back((first + k) * step);
}

double ColourScale::Share(double value) const {
  return std::clamp((value - ticks_.front()) / (ticks_.back() - ticks_.front()), 0.0, 1.0);
}

std::string ColourScale::ColourAt(double share) {
  const double place = (1.0 - share) * (kViridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  const double part = place - static_cast<double>(below);
  const auto mixed = [&](double Rgb::*channel) {
    return static_cast<int>(
        std::lround((1.0 - part) * kViridis[below].*channel + part * kViridis[below + 1].*channel));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(&Rgb::red), mixed(&Rgb::green),
                     mixed(&Rgb::blue));
}

}  // namespace ronda
