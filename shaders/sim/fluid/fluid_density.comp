// One thread a slot: the density of its fluid particle and the multiplier of its constraint (Macklin and Mueller 2013,
// eqs. 1, 8-11): C = rho / rho0 - 1, lambda = -C / (sum w |grad C|^2 + epsilon). Solids and walls count by the fraction
// of the kernel that they cover. Only too high a density counts, C >= 0: pressure does not hold fluids together.
#include "sim/common/kernel.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/fluid/walls/fluid_colliders.glsl"
#include "sim/fluid/walls/solid_cover.glsl"
#include "sim/fluid/walls/wall_cover.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, SlotPressures, newSlotPressures);
BUFFER(vec4, SlotWalls, newSlotWalls);
BUFFER(vec4, SlotSolids, newSlotSolids);

/// Sums over fluid neighbours, in units of the kernel's height and steepness: the fraction of the kernel, the squares
/// of its slopes, and its gradient.
struct Sums {
    float fraction, squares;
    vec3 gradient;
};

void add(inout Sums sums, vec3 x, float inverseReach, uint slot)
{
    vec3 r = x - fetchSlotPosition(slot).position;
    float squared = dot(r, r), a = 1.0 - min(sqrt(squared) * inverseReach, 1.0), cube = a * a * a;
    sums.fraction += fluidShape(a);
    sums.squares += cube * cube * squared;
    sums.gradient += cube * r;
}

Sums sumsOver(uint k, uint count, vec3 x)
{
    // A list whose length is not a multiple of four ends with the slot itself, which is subtracted again.
    Sums sums = Sums(1.0 - float(-count & 3u), 0.0, vec3(0));
    float inverseReach = 1.0 / sim.fluidReach, steepness = fluidSteepness();
    for (uint n = 0u, texel = neighbourTexel(k, 0u); n < count; n += 4u, texel += NEIGHBOUR_BLOCK) {
        uvec4 slots = fetchNeighbours(texel);
        add(sums, x, inverseReach, slots.x);
        add(sums, x, inverseReach, slots.y);
        add(sums, x, inverseReach, slots.z);
        add(sums, x, inverseReach, slots.w);
    }
    return Sums(sim.fluidVolume * sums.fraction, steepness * steepness * sums.squares, steepness * sums.gradient);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k);
    NeighbourCounts counts = fetchFluidCounts(k, i);
    vec3 x = fetchSlotPosition(k).position;
    Sums sums = sumsOver(k, counts.fluids, x);
    SolidCover solids = solidCover(k, counts.solids, x);
    WallCover walls = wallCover(k, x);
    float density = sums.fraction + walls.fraction + solids.fraction;
    vec3 own = sums.gradient + walls.gradient + solids.slope;
    // All constraints around are solved at once, each as if alone: larger errors than this would overshoot.
    float tooMuch = clamp(density - 1.0, 0.0, MOST_FLUID_ERROR);
    // Where the slopes of solids cancel, as between two of them, there is no way out: a harder push does not help.
    float opposed = max(solids.squares - dot(solids.slope, solids.slope), 0.0);
    float lambda = -FLUID_RELAXATION * tooMuch / (dot(own, own) + opposed + sums.squares + sim.fluidSoftness);
    newSlotPressures[k] = pack(SlotPressure(x, lambda / max(fetchMass(i).inverseMass, 1e-20)));
    newSlotWalls[k] = pack(SlotWallCover(walls.gradient, density));
    newSlotSolids[k] = pack(SlotSolidCover(solids.slope, solids.weights > 0.0 ? 1.0 / solids.weights : 0.0));
}
