// The part of a fluid particle's smoothing kernel that solid particles cover.
#include "sim/fluid/walls/solid_cells.glsl"

/// The density that they add, and how that changes with its position.
struct SolidCover {
    vec3 slope;      // of the fraction [1/m]
    float fraction;  // of the kernel
    float weights;   // sum of solidWeight()
    vec3 move;       // mean of the solids', by their weights [m]
    float opposed;   // squares of the slopes of each, as far as they push against each other [1/m2]
    mat3 moment;     // what they add to M of fluid_shape, besides the fraction
    float fastest;   // speed of the fastest of them when the step began [m/s]; NO_SOLID
    float between;   // 1 where solids are on all sides, 0 where they are on one
};

SolidCover noSolids()
{
    return SolidCover(vec3(0), 0.0, 0.0, vec3(0), 0.0, mat3(0), NO_SOLID, 0.0);
}

/// The cover by the solid neighbours of slot k, for a particle at x.
SolidCover solidCover(uint k, uint count, vec3 x)
{
    SolidCover cover = noSolids();
    vec3 outward = vec3(0);
    for (uint n = 0u; n < count; ++n) {
        uint solid = fetchSolidNeighbour(k, n);
        SolidCell cell = fetchSolidCell(solid);
        vec3 offset = x - cell.centre;
        float r = length(offset), weight = solidWeight(r);
        CellCover covered = cellCover(cell, offset);
        cover.fraction += covered.fraction;
        cover.slope += covered.slope;
        cover.moment += covered.moment;
        cover.opposed += dot(covered.slope, covered.slope);
        cover.weights += weight;
        if (r < sim.fluidListReach) cover.fastest = max(cover.fastest, length(fetchSlotVelocity(solid).velocity));
        cover.move += weight * cell.move;
        outward += weight / max(r, 1e-9) * offset;
    }
    cover.move /= max(cover.weights, 1e-20);
    // On one side of a surface, the slopes of its cells cancel along it only.
    cover.between = 1.0 - smoothstep(0.3, 0.6, length(outward) / max(cover.weights, 1e-20));
    cover.opposed = max(cover.opposed - dot(cover.slope, cover.slope), 0.0) * cover.between;
    return cover;
}
