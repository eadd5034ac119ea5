#pragma once

#include "render/marks/mark_pen.h"
#include "sim/world/world.h"

namespace knuckle {

/// Red, green and blue of the marks of joints of a type, as displayed, 0-1.
Eigen::Vector3f markColor(JointType type);

/// Marks of all joints of a world, which tell their types: a disc for a ball, a bar along the axis for a hinge, one
/// along each axis for a universal joint, a square for a stiff one. Limits are fans: how far the child may turn against
/// the parent, with which they move; of a hinge the way to the child's middle at rest, of a ball the child's axis.
/// @param legend whether the picture says which mark is what.
Marks jointMarks(const World& world, bool legend);

}  // namespace knuckle
