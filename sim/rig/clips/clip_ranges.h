#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "sim/rig/actor.h"
#include "sim/rig/actor_options.h"
#include "sim/rig/figure.h"
#include "sim/world/animation/animation.h"

namespace knuckle {

/// What an actor's joints and bodies have to allow so that clips can be played.
struct ClipNeeds {
    std::vector<JointLimits> limits;                ///< Per joint: its own, widened.
    std::vector<std::array<uint32_t, 2>> filtered;  ///< Pairs of bodies that must never touch.
    std::vector<std::string> notes;                 ///< What is not allowed, one sentence each.
};

/// Needs of the model's own clips: limits that include every turn with 5 degrees to spare, equal for both sides, except
/// for turns that lastingTurns() leaves out, which are noted. Parts that a person's body does not have get limits that
/// are GUESSED. Limits that options give stay.
ClipNeeds rangesInClips(const Figure& figure, const Actor& actor, const ArticulationOptions& options);

/// Needs of clips that will be played: limits that include every turn with 5 degrees to spare, and pairs of bodies that
/// overlap in most of one.
ClipNeeds needsOf(const Actor& actor, std::span<const BodyClip* const> clips);
inline ClipNeeds needsOf(const Actor& actor, const BodyClip& clip)
{
    const BodyClip* const clips[] = {&clip};
    return needsOf(actor, clips);
}

/// Gives the actor the limits and filtered pairs that clips need.
void allow(Actor& actor, const ClipNeeds& needs);

/// Removes from a clip the turns for which joint limits are not widened, before needsOf(): turns that lastingTurns()
/// leaves out are held at the future limits. @returns a sentence about it, empty if the whole clip fits.
std::string holdWithinLimits(const Actor& actor, BodyClip& clip);

}  // namespace knuckle
