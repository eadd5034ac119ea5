// What walls and solids add to the sums of fluid_density, and note for fluid_pressure.
#include "sim/fluid/walls/fluid_colliders.glsl"
#include "sim/fluid/walls/solid_cover.glsl"
#include "sim/fluid/walls/wall_cover.glsl"

FLOAT_TEXELS(newSlotWalls)
#ifdef SOLIDS
FLOAT_TEXELS(newSlotSolids)

/// What walls and solids that face each other lack.
float gainOf(WallCover walls, SolidCover solids)
{
    float side = 0.5 * solids.fraction, gain = mix(1.0, gapGain(side, side), solids.between);
    float both = length(walls.gradient) * length(solids.slope), facing = -dot(walls.gradient, solids.slope);
    float apart = clamp(facing / max(both, 1e-12), 0.0, 1.0);
    return gain * mix(1.0, gapGain(walls.fraction, solids.fraction), apart);
}
#endif

/// The sides of slot k, which lists that many solids.
Sides sidesOf(uint k, uint solidCount, Own own)
{
    WallCover walls = wallCover(k, own.position);
#ifdef SOLIDS
    SolidCover solids = solidCover(k, solidCount, own.position);
    float gain = gainOf(walls, solids), inverseWeight = solids.weights > 0.0 ? 1.0 / solids.weights : 0.0;
    walls.gradient *= gain, solids.slope *= gain;
    imageStore(newSlotSolids, int(k), pack(SlotSolidCover(solids.slope, inverseWeight)));
#else
    SolidCover solids = noSolids();
    float gain = 1.0;
#endif
    imageStore(newSlotWalls, int(k), vec4(walls.gradient, 0));
    float toWalls = dot(own.move, own.even * walls.gradient);
    float toSolids = dot(own.move - solids.move, evenAcross(own.even, solids.slope) * solids.slope);
    // Twice, as fluid_pressure pushes by them.
    return Sides(walls.gradient + solids.slope, walls.fraction + solids.fraction, solids.opposed,
                 2.0 * (toWalls + toSolids), gain, solids.fastest);
}
