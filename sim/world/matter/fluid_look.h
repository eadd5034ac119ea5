#pragma once

#include <cstdint>

namespace knuckle {

/// What is drawn of matter: its particles as spheres, the surface around those of a fluid, the shape of a rigid body.
/// Automatic: the surface of a fluid, otherwise particles.
enum class DrawnAs : uint32_t { Automatic, Particles, Surface, Shape };

/// How a fluid's surface looks; Material::color is what white light becomes after 1 / absorption.
struct FluidLook {
    DrawnAs drawn = DrawnAs::Automatic;
    float absorption = 1.0f;  ///< [1/m], >= 0.
    float scattering = 0.3f;  ///< Light that comes back out of it, as from milk [1/m], >= 0.
    float foam = 1.0f;        ///< How readily it makes foam, spray and bubbles where it breaks, >= 0; thin ones only.
    float emission = 0.0f;    ///< Light that it sends out where it is thick, in its colour, as SurfaceFinish has it.
};

}  // namespace knuckle
