#pragma once

#include <vector>

#include "sim/rig/actor.h"
#include "sim/world/animation/animation.h"

namespace knuckle {

/// Over the ground: x and z.
using Ground = Eigen::Vector2f;

inline Ground groundOf(const Vector3f& p)
{
    return {p.x(), p.z()};
}

/// What of a figure touches the ground between two keys of a clip: the middle of it at both, in the clip's own frame.
struct GroundContact {
    Ground before{0, 0}, after{0, 0};
    bool isThere = false;  ///< Whether anything does.
};

/// Per key but the last: from it to the next. What is within half a diameter of a figure's lowest point touches, unless
/// that is high above the lowest of the clip; what moves up or down counts less.
std::vector<GroundContact> groundContacts(const Actor& actor, const BodyClip& clip);

}  // namespace knuckle
