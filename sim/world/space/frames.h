#pragma once

#include "sim/world/space/pose.h"

namespace knuckle {

/// The shortest turn that brings one direction to another; a half turn about any axis across them where they are
/// opposite. Unit for all vectors; no turn where one is zero.
Quaternionf turnBetween(const Vector3f& from, const Vector3f& to);

/// Level and unit, to the right of what looks against `back`, unit; as perpendicular() of axes.glsl.
Vector3f levelRight(const Vector3f& back);

}  // namespace knuckle
