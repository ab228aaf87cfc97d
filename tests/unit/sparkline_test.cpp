#include "deploy/sparkline.h"

#include <catch2/catch.hpp>
#include <limits>
#include <string>

namespace ronda {
namespace {

std::string Drawn(std::vector<double> values, const CurveMarks& marks, int columns = 80) {
  std::string text;
  for (const CurveBlock& block : Sparkline(std::move(values), marks, columns)) {
    text += BlockText(block);
  }
  return text;
}

/// "-": below the reference; "+": not below; "?": there is none.
std::string Sides(std::vector<double> values, const CurveMarks& marks) {
  std::string text;
  for (const CurveBlock& block : Sparkline(std::move(values), marks, 80)) {
    text += block.side == Side::kBelow ? '-' : block.side == Side::kNotBelow ? '+' : '?';
  }
  return text;
}

TEST_CASE("The reference is the middle of the scale, the bound its bottom") {
  // Steps of 1 from 10: the reference is 4 above the bound, so that each step is a level.
  const CurveMarks marks{.bound = 10.0, .reference = 14.0};
  CHECK(Drawn({10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0, 17.0}, marks) == "▁▂▃▄▅▆▇█");
  CHECK(Drawn({40.0, 18.0, 9.0}, marks) == "██▁");
}

TEST_CASE("A point is below the reference or it is not, by its block and by its side") {
  const CurveMarks marks{.bound = 9.97, .reference = 13.74};
  const std::vector<double> values{13.74, std::nextafter(13.74, 0.0), 12.95, 13.8};
  CHECK(Drawn(values, marks) == "▅▄▄▅");
  CHECK(Sides(values, marks) == "+--+");
}

TEST_CASE("Without a reference the scale ends at the largest value, and no side is known") {
  CHECK(Drawn({18.0, 14.0, 12.0}, {.bound = 10.0, .reference = {}}) == "█▅▃");
  CHECK(Sides({18.0, 14.0}, {.bound = 10.0, .reference = {}}) == "??");
  CHECK(Drawn({18.0, 14.0, 10.0}, {}) == "█▅▁");
}

TEST_CASE("Without a bound the scale begins at the least value") {
  CHECK(Drawn({16.0, 14.0, 12.0}, {.bound = {}, .reference = 14.0}) == "█▅▁");
}

TEST_CASE("A reference that is not above the bottom does not set the scale, but the sides") {
  const CurveMarks marks{.bound = 10.0, .reference = 9.0};
  CHECK(Drawn({18.0, 14.0, 10.0}, marks) == "█▅▁");
  CHECK(Sides({18.0, 8.0}, marks) == "+-");
}

TEST_CASE("One point is one block, no point is none") {
  CHECK(Drawn({13.0}, {.bound = 10.0, .reference = 14.0}) == "▄");
  CHECK(Drawn({13.0}, {}) == "▄");
  CHECK(Drawn({}, {.bound = 10.0, .reference = 14.0}).empty());
}

TEST_CASE("A constant curve is level") {
  CHECK(Drawn({13.0, 13.0, 13.0}, {}) == "▄▄▄");
  CHECK(Drawn({15.0, 15.0}, {.bound = 10.0, .reference = 14.0}) == "▆▆");
  CHECK(Drawn({15.0, 15.0}, {.bound = 10.0, .reference = {}}) == "██");
}

TEST_CASE("More values than columns: each block is the mean of its share, in order") {
  // Shares of 2: 17, 15, 11.
  const std::vector<double> values{20.0, 14.0, 16.0, 14.0, 11.0, 11.0};
  CHECK(Drawn(values, {.bound = 10.0, .reference = 14.0}, 3) == "█▆▂");
  CHECK(Sparkline(std::vector<double>(1000, 1.0), {}, 7).size() == 7);
  CHECK(Sparkline(values, {}, 0).empty());
}

TEST_CASE("What is not finite is left out") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(Drawn({nan, 11.0, infinity, 15.0}, {.bound = 10.0, .reference = 14.0}) == "▂▆");
  CHECK(Drawn({18.0, 10.0}, {.bound = nan, .reference = infinity}) == "█▁");
  CHECK(Drawn({1e308, 1e308, 1.0, 1.0}, {}, 2).size() == 2 * std::string("█").size());
}

}  // namespace
}  // namespace ronda
