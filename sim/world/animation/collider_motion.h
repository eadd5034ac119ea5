#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/animation/animation.h"

namespace knuckle {

struct Collider;

/// Colliders that move together as a clip of one body says, whatever they meet.
struct ColliderMotion {
    uint32_t firstCollider = 0;
    std::vector<Pose> places;  ///< Of those from the first on, in the frame that moves.
    Pose pose;                 ///< Of that frame in the world, where the clip leaves it as it is.
    ClipPlay play;
};

/// The motion of its frame, as that of an object with one body.
Animation animationOf(const ColliderMotion& motion);

/// Colliders of a world where they are at a time [s]. What shaders/sim/animation does on the GPU, which a test holds it
/// to.
std::vector<Collider> collidersAt(const World& world, double time);

/// The part of validate() that is about them. @throws InputError, std::logic_error.
void validateColliderMotions(const World& world);

}  // namespace knuckle
