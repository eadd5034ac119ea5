#pragma once

#include <string>
#include <vector>

#include "sim/rig/figure.h"
#include "sim/rig/limbs/body_draft.h"

namespace knuckle {

/// Notes which bones have no body of their own, and why: a sentence for each body and reason. Fingers and other rows of
/// bones are counted, of other bones the first few are named; ActorBody::mergedBones has all of them.
/// @param isPlanned whether a coarser actor decided that.
void noteMerged(const Figure& figure, const std::vector<BodyDraft>& drafts, bool isPlanned,
                std::vector<std::string>& notes);

}  // namespace knuckle
