#pragma once

#include <vector>

#include "sim/world/builder/builder.h"

namespace knuckle {

/// Where a joint puts its particles (paper, section 4 and figure 3), in the frame of its JointSpec [m].
struct JointPlaces {
    std::vector<Vector3f> shared;       ///< Shared by A and B; universal: empty.
    std::vector<Vector3f> limits;       ///< Hinge: A's own particles beside the axis, which block one side.
    std::vector<Vector3f> sharedWithA;  ///< Universal: the middle body's ends of the hinge at A ...
    std::vector<Vector3f> sharedWithB;  ///< ... and of the crossed hinge at B ...
    std::vector<Vector3f> middle;       ///< ... and its particle where they cross.
};

/// @param diameter particle diameter [m]: the spacing of the joint's particles.
/// @throws std::logic_error for an axis or `along` of length zero, or parallel ones.
JointPlaces jointPlaces(const JointSpec& spec, float diameter);

/// "ball", "hinge", "stiff" or "universal".
const char* jointTypeName(JointType type);

}  // namespace knuckle
