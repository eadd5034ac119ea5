#pragma once

#include "sim/world/world.h"

namespace knuckle {

/// Signed distance of a point to a collider's surface [m], negative inside.
float colliderDistance(const World& world, const Collider& collider, const Vector3f& point);

}  // namespace knuckle
