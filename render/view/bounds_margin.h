#pragma once

#include "sim/world/world.h"

namespace knuckle {

/// How far shapes of bodies and skins stand out at most from the spheres of the particles that they are drawn instead
/// of, in the rest pose [m], at most half of `size`: cameras go by the particles.
float boundsMargin(const World& world, float size);

}  // namespace knuckle
