#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/animation/animation.h"

namespace knuckle {

struct Collider;

/// Colliders that a clip of one body moves together, whatever they meet.
struct ColliderMotion {
    uint32_t firstCollider = 0;
    std::vector<Pose> places;  ///< Of its colliders, from the first on, in the moving frame.
    Pose pose;                 ///< Of that frame in the world, before the clip moves it.
    ClipPlay play;
};

/// The motion of its frame, as that of an object with one body.
Animation animationOf(const ColliderMotion& motion);

/// Whether a clip moves a collider of a world, by its index.
bool moves(const World& world, size_t collider);

/// Colliders of a world at their places at a time [s]. The GPU does the same in shaders/sim/animation; a test compares
/// both.
std::vector<Collider> collidersAt(const World& world, double time);

/// Validates collider motions. @throws InputError, std::logic_error.
void validateColliderMotions(const World& world);

}  // namespace knuckle
