#pragma once
// Where a test's participants meet: each test has a DDS domain of its own, beyond those that runs
// take (1 … 100), and each test process a run id of its own, so that two test suites may run side
// by side on one machine.
#include <unistd.h>

#include <string>

namespace ronda {

inline constexpr int kDeliveryDomain = 101;
inline constexpr int kLimiterDomain = 102;
inline constexpr int kNewReplayDomain = 103;
inline constexpr int kFormerReplayDomain = 104;
inline constexpr int kRefusalsDomain = 105;
inline constexpr int kStrangersDomain = 106;
inline constexpr int kSamplesDomain = 107;
inline constexpr int kPrioritiesDomain = 108;
inline constexpr int kNewReplayForLearnerDomain = 109;
inline constexpr int kNewLearnerDomain = 110;
inline constexpr int kWeightsDomain = 111;
inline constexpr int kLargeWeightsDomain = 112;
inline constexpr int kForeignWeightsDomain = 113;
inline constexpr int kOlderWeightsDomain = 114;
inline constexpr int kStrangersWeightsDomain = 115;
inline constexpr int kReportsDomain = 116;
inline constexpr int kControlDomain = 117;
inline constexpr int kStatusDomain = 118;
inline constexpr int kKilledReplayDomain = 119;
inline constexpr int kSmallBuffersDomain = 120;
inline constexpr int kDeadReaderDomain = 121;
inline constexpr int kLostSamplesDomain = 122;

/// The run id of this test process; programs that it starts are told.
inline std::string TestRun() { return "test-" + std::to_string(getpid()); }

}  // namespace ronda
