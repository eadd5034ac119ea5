#pragma once

#include "sim/rig/actor.h"
#include "sim/rig/mesh/solid.h"

namespace knuckle {

/// How well an actor's particles represent a mesh.
struct FillError {
    double volume = 0.0;   ///< Of the particles, as cubes of a diameter, over that of the solid; infinite if the latter
                           ///< is 0.
    double surface = 0.0;  ///< Root mean square over the surface, of the nearest particle's distance less half a
                           ///< diameter [diameters].
};

FillError fillError(const Actor& actor, const Solid& solid);

}  // namespace knuckle
