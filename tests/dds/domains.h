#pragma once
// The DDS domain of each test: each has its own, beyond those that runs take (1 … 100), so that
// tests may run side by side.

namespace ronda {

inline constexpr int kDeliveryDomain = 101;
inline constexpr int kLimiterDomain = 102;
inline constexpr int kSamplesDomain = 103;
inline constexpr int kPrioritiesDomain = 104;
inline constexpr int kNewReplayDomain = 105;
inline constexpr int kFormerReplayDomain = 106;
inline constexpr int kRefusalsDomain = 107;
inline constexpr int kWeightsDomain = 108;
inline constexpr int kForeignWeightsDomain = 109;
inline constexpr int kOlderWeightsDomain = 110;
inline constexpr int kReportsDomain = 111;
inline constexpr int kControlDomain = 112;
inline constexpr int kStatusDomain = 113;
inline constexpr int kStrangersDomain = 114;
inline constexpr int kKilledReplayDomain = 115;
inline constexpr int kSmallBuffersDomain = 116;

}  // namespace ronda
