#pragma once

#include <memory>
#include <span>
#include <vector>

#include "app/scene/scene_context.h"

namespace knuckle {

/// The surface of a soft object: that of its box, ball or capsule, as large as its particles together, or its model's.
/// @param positions of its particles at rest [m].
std::shared_ptr<const SoftHull> makeSoftHull(const ObjectEntry& entry, std::span<const Vector3f> positions);

}  // namespace knuckle
