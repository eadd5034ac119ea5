#pragma once

#include "app/export/rig.h"
#include "sim/world/matter/body_shape.h"

namespace knuckle {

/// Adds a shape's surface to the mesh of a rig, moved by one bone: triangles that are counter-clockwise from outside.
/// @param color linear.
void addShape(Rig& rig, const BodyShape& shape, uint32_t bone, const Vector3f& color);

}  // namespace knuckle
