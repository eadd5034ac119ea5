#pragma once

#include "sim/world/space/pose.h"

namespace knuckle {

/// The shortest turn that brings one direction to another; if they are opposite, a half turn about any axis across
/// them. Unit for all vectors; no turn if one is zero.
Quaternionf turnBetween(const Vector3f& from, const Vector3f& to);

/// Level and unit, to the right of a viewer who looks against `back`, unit; as perpendicular() of axes.glsl.
Vector3f levelRight(const Vector3f& back);

}  // namespace knuckle
