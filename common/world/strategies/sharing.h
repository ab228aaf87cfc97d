#pragma once
// What a robot of a reactive strategy is told of the others, and so which neighbours it chooses
// from.
//
//   own     its own visits
//   shared  everyone's visits: robots that meet then follow each other, for they see the same
//   claims  everyone's visits, and the neighbours that nobody else heads to or stands on; all
//           neighbours where there is none of these
#include <vector>

#include "common/world/belief.h"

namespace ronda {

enum class Sharing { kOwn, kShared, kClaims };

constexpr Knowledge KnowledgeOf(Sharing sharing) {
  return {.visits = sharing == Sharing::kOwn ? Knowledge::Visits::kOwn : Knowledge::Visits::kShared,
          .intentions = sharing == Sharing::kClaims};
}

/// The neighbours to choose from, ascending, by their places in `neighbours(belief.vertex)`. Writes
/// into `places`. O(degree), for kClaims O(degree · N).
void FindCandidates(const Belief& belief, Sharing sharing, std::vector<int>& places);

}  // namespace ronda
