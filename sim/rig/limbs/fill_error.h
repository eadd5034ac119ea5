#pragma once

#include "sim/rig/actor.h"
#include "sim/rig/mesh/solid.h"

namespace knuckle {

/// How well an actor's particles stand for a mesh.
struct FillError {
    double volume = 0.0;   ///< Of the particles, as cubes of a diameter, over that of the solid; infinite where that
                           ///< is 0.
    double surface = 0.0;  ///< How much farther or nearer than half a diameter the nearest particle is from the mesh,
                           ///< root of the mean square over the surface [diameters].
};

FillError fillError(const Actor& actor, const Solid& solid);

}  // namespace knuckle
