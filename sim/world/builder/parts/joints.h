#pragma once

#include <vector>

#include "sim/world/builder/builder.h"

namespace knuckle {

/// Places of a joint's particles (paper, section 4 and figure 3), in the frame of its JointSpec [m].
struct JointPlaces {
    std::vector<Vector3f> shared;  ///< Shared by both bodies; universal: empty.
    std::vector<Vector3f> limits;  ///< Hinge: the parent's own particles beside the axis, which block one side.
    std::vector<Vector3f> sharedWithParent;  ///< Universal: the middle body's ends of the hinge at the parent ...
    std::vector<Vector3f> sharedWithChild;   ///< ... and of the crossed hinge at the child ...
    std::vector<Vector3f> middle;            ///< ... and its particle where they cross.
};

/// @param diameter particle diameter [m]: the spacing of the joint's particles.
/// @throws std::logic_error for an axis or `along` of length zero, or parallel ones.
JointPlaces jointPlaces(const JointSpec& spec, float diameter);

/// From parent to child, unit, perpendicular to the axis.
Vector3f alongOf(const JointSpec& spec);

/// "ball", "hinge", "stiff" or "universal".
const char* jointTypeName(JointType type);

}  // namespace knuckle
