#pragma once

#include "render/marks/mark_pen.h"
#include "sim/world/world.h"

namespace knuckle {

/// Red, green and blue of the marks of joints of a type, as displayed, 0-1.
Eigen::Vector3f markColor(JointType type);

/// Marks of all joints of a world, which show their types: a disc for a ball, a bar along the axis for a hinge, one
/// along each axis for a universal joint, a square for a stiff one. Limits are fans that move with the parent and show
/// how far the child may turn against it: for a hinge the direction to the child's middle at rest, for a ball the
/// child's axis.
/// @param legend whether the picture explains the marks.
Marks jointMarks(const World& world, bool legend);

}  // namespace knuckle
