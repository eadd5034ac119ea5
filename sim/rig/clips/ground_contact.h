#pragma once

#include <vector>

#include "sim/rig/actor.h"
#include "sim/world/animation/animation.h"

namespace knuckle {

/// A place on the ground: x and z.
using Ground = Eigen::Vector2f;

inline Ground groundOf(const Vector3f& p)
{
    return {p.x(), p.z()};
}

/// The part of a figure that touches the ground between two keys of a clip: its middle at both, in the clip's own
/// frame.
struct GroundContact {
    Ground before{0, 0}, after{0, 0};
    bool isThere = false;  ///< Whether anything touches.
};

/// Per key except the last: the contact from it to the next. Particles within half a diameter of a figure's lowest
/// point touch, unless that is high above the lowest point of the clip; those that move up or down count less.
std::vector<GroundContact> groundContacts(const Actor& actor, const BodyClip& clip);

}  // namespace knuckle
