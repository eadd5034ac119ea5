#pragma once

#include "render/settings.h"
#include "sim/gpu/shader_source.h"
#include "sim/world/world.h"

namespace knuckle {

/// Whether colours show a number that only fluids have, and that only the solver knows.
inline bool showsFluids(const RenderSettings& settings)
{
    return settings.colorBy == ColorBy::Pressure || settings.colorBy == ColorBy::Density;
}

/// Whether colours show a number that the solver keeps for that alone (World::shown).
inline bool isKept(ColorBy quantity)
{
    return quantity == ColorBy::Age || quantity == ColorBy::ContactForce;
}

/// What the solver must keep for a picture.
inline ShownQuantities keptFor(const RenderSettings& settings)
{
    return {.ages = settings.colorBy == ColorBy::Age, .contactForces = settings.colorBy == ColorBy::ContactForce};
}

/// From the low to the high end of a palette.
struct ColorScale {
    float low = 0.0f, high = 1.0f;  ///< In its unit.
    const char* quantity = "";      ///< Its name, for people.
    const char* unit = "";          ///< Empty: a plain number.
};

/// RenderSettings::colorScale, or one that suits the world: of speed 0 to speedScale; of pressure 0 to the weight of
/// the fluid above its lowest as it is at the start, at least 1000 Pa; of density 0.9 to 1.1; of strain 0 to 0.3; of
/// age 0 to 5 s; of contacts' forces 0 to the weight of a column of solid particles as high as they stand at the start,
/// at least of ten.
ColorScale colorScaleOf(const World& world, const RenderSettings& settings);

/// The palette that is meant: by itself `heat` for speed, `diverging` for density, else `viridis`.
Palette paletteOf(const RenderSettings& settings);

/// The colour at a place from 0 to 1 on the palette, linear RGB, as shaders have it.
Vector3f scaleColor(Palette palette, float share);

/// What shaders that show a quantity are compiled with; none where colours show no number.
Defines colorDefines(const World& world, const RenderSettings& settings);

}  // namespace knuckle
