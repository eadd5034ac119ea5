#pragma once

#include "app/json/json.h"
#include "sim/world/world.h"

namespace knuckle {

/// Rotation about the fixed axes x, y, z in this order. @param degrees of each.
Quaternionf rotationOf(const Vector3f& degrees);
/// The same from `rotation`; identity if there is none.
Quaternionf readRotation(const Json& json);

/// The box, sphere, capsule or plane of a drain, a release or a field.
Region readRegion(const Json& json);

}  // namespace knuckle
