#pragma once
// Random numbers: xoshiro256++ (Blackman & Vigna 2021), seeded by splitmix64 (Steele, Lea & Flood
// 2014).
//
// Every random choice takes an Rng that was split from the configuration's seed, so the same seed
// gives the same run. Satisfies UniformRandomBitGenerator. Thread-compatible. The state is four
// words and can be saved.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace ronda {

class Rng {
 public:
  using result_type = std::uint64_t;
  using State = std::array<std::uint64_t, 4>;

  explicit Rng(std::uint64_t seed) {
    for (auto& word : state_) word = NextSplitMix(seed);
  }
  explicit Rng(const State& state) : state_(state) {}

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  result_type operator()() {
    const std::uint64_t result = Rotate(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = Rotate(state_[3], 45);
    return result;
  }

  /// Uniform in [0, 1), 53 bits.
  double Uniform() { return static_cast<double>((*this)() >> 11) * 0x1.0p-53; }

  /// Uniform in {0, …, n − 1}; n ≥ 1. Multiply-shift (Lemire 2019); its bias is below n / 2^32.
  std::uint32_t Below(std::uint32_t n) {
    return static_cast<std::uint32_t>((((*this)() >> 32) * n) >> 32);
  }

  /// Standard normal (Box & Muller 1958, one of the pair).
  double Normal() {
    const double u = 1.0 - Uniform();
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * Uniform());
  }

  const State& state() const { return state_; }

  static std::uint64_t NextSplitMix(std::uint64_t& seed) {
    std::uint64_t z = (seed += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }

 private:
  static std::uint64_t Rotate(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

  State state_;
};

/// An independent stream for each (seed, stream): actor 3's stream stays the same whatever actor 2
/// draws.
inline Rng SplitSeed(std::uint64_t seed, std::uint64_t stream) {
  std::uint64_t mixed = Rng::NextSplitMix(seed) ^ (stream * 0xD1342543DE82EF95ull + 1);
  return Rng(Rng::NextSplitMix(mixed));
}

}  // namespace ronda
