#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "sim/actor/bodies/bone_bodies.h"

namespace knuckle {

/// Says which bones have no body of their own, and why: a sentence for each body and reason. Fingers and other rows of
/// bones are counted, of other names the first few are told; ActorBody::mergedBones has all of them.
/// @param wanted what options want bones to be, rolesWanted().
void noteMerged(const Model& model, std::span<const BoneAnatomy> anatomy, const std::map<uint32_t, BoneRole>& wanted,
                const std::vector<BodyDraft>& drafts, std::vector<std::string>& notes);

}  // namespace knuckle
