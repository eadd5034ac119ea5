#pragma once

#include <vector>

#include "app/scene/scene_context.h"
#include "sim/rig/clips/clip_ranges.h"

namespace knuckle {

/// How an actor's clips are played, and what its joints must allow for them.
struct PlayedClips {
    std::vector<ClipPlay> plays;
    ClipNeeds needs;
};
/// Adds the clips of an actor's `animation` or `pose`. @throws InputError for clips that do not exist or do not fit.
PlayedClips readClips(const ObjectEntry& entry, const Actor& actor);

/// Makes the copies of an actor move as their clips say. @param objects of the world, a copy each.
void animateActors(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects,
                   const std::vector<ClipPlay>& plays);

/// Whether an `animation`, a `pose` or a change names a clip.
bool namesClip(const Json& clip);
/// Whether an actor has an `animation` or a `pose`.
bool isAnimated(const Json& actor);

}  // namespace knuckle
