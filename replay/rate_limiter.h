#pragma once
// Keeps sampling and inserting in step: `samples_per_insert` transitions are sampled for each one
// inserted, give or take `error_buffer` samples, once `min_size` transitions are there (Cassirer et
// al. 2021, Reverb, §3.3).
//
// With D = inserted · samples_per_insert − sampled, sampling needs D − B ≥ min_size ·
// samples_per_insert − error_buffer, and inserting keeps D ≤ min_size · samples_per_insert +
// error_buffer. Both sides can never wait at once: a setting where they could is refused. A value;
// thread-compatible; O(1).
#include <cstdint>

namespace ronda {

struct RateLimiterConfig {
  std::uint64_t min_size = 5000;    // transitions before the first sample
  double samples_per_insert = 8.0;  // > 0
  double error_buffer = 65536.0;    // samples
};

class RateLimiter {
 public:
  /// Throws InputError with a sentence when both sides could wait for each other with batches of
  /// `batch_size` samples.
  RateLimiter(const RateLimiterConfig& config, std::uint64_t batch_size);

  void Inserted(std::uint64_t count) { inserted_ += count; }
  void Sampled(std::uint64_t count) { sampled_ += count; }

  /// How many transitions may be inserted now; 0: the actors wait for the learner.
  std::uint64_t InsertRoom() const;
  /// Whether `count` transitions may be sampled now, with `size` held; false: the learner waits for
  /// the actors.
  bool CanSample(std::uint64_t count, std::uint64_t size) const;

  std::uint64_t inserted() const { return inserted_; }
  std::uint64_t sampled() const { return sampled_; }

 private:
  RateLimiterConfig config_;
  std::uint64_t inserted_ = 0;
  std::uint64_t sampled_ = 0;
};

}  // namespace ronda
