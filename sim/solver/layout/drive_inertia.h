#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// What a drive moves, in the axes of the rest pose. Made from the World alone.
///
/// A spring of a frequency f has the stiffness (2 pi f)^2 times this, so that a finger and a thigh feel alike.

/// Against turns of a body about the joint with which it hangs on its parent, each with all that hangs on it, stiff as
/// in the rest pose, and free to move but for the joint (where what is fixed holds the parent's side, that stays)
/// [kg m2]. @param links of the object, parents known by them. @param body, within the object; not the first.
Eigen::Matrix3d turnedInertia(const World& world, const Object& object, const std::vector<AnimatedLink>& links,
                              uint32_t body);

/// What is held with a pinned body: all bodies that are nearer to it up the tree than to another one that is pinned.
struct PinnedMass {
    double mass = 0.0;                                  ///< [kg]
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< About the body's mass centre [kg m2].
};

/// @param pinned bodies within the object. @returns one for each of them.
std::vector<PinnedMass> pinnedMasses(const World& world, const Object& object, const std::vector<AnimatedLink>& links,
                                     const std::vector<uint32_t>& pinned);

}  // namespace knuckle
