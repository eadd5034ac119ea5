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

/// Of the model's own clips: limits that take in every turn with 5 degrees to spare, those of both sides alike, but for
/// what lastingTurns() leaves out, which is a note. What is no part of a person's body has limits that are GUESSED.
/// Limits that somebody gave stay as they are.
ClipNeeds rangesInClips(const Figure& figure, const Actor& actor, const ArticulationOptions& options);

/// Of clips that are going to be played: limits that take in every turn with 5 degrees to spare, and pairs of bodies
/// that overlap in most of one.
ClipNeeds needsOf(const Actor& actor, std::span<const BodyClip* const> clips);
inline ClipNeeds needsOf(const Actor& actor, const BodyClip& clip)
{
    const BodyClip* const clips[] = {&clip};
    return needsOf(actor, clips);
}

/// Gives the actor what its clips need.
void allow(Actor& actor, const ClipNeeds& needs);

/// Leaves out of a clip what the limits of its actor's joints are not widened for, before needsOf(): what
/// lastingTurns() leaves out is held where the limits will be. @returns a sentence about it, empty where all of the
/// clip fits.
std::string holdWithinLimits(const Actor& actor, BodyClip& clip);

}  // namespace knuckle
