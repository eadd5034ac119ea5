// One thread a slot: how compressed its fluid particle is and the multiplier of its density constraint (Macklin and
// Mueller 2013, eqs. 8-11, with masses). Compression grows by the divergence of the moves since the last substep, with
// the same gradients by which fluid_pressure pushes: so what is pressed gives back the work that went in. (The density
// that kernels sum up would change where fluid only shears.) RELAX: as kernels sum it up.
#include "sim/common/kernel.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/pressure/slot_pressures.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/common/fluid_past.glsl"
#include "sim/fluid/walls/fluid_colliders.glsl"
#include "sim/fluid/walls/solid_cover.glsl"
#include "sim/fluid/walls/wall_cover.glsl"
#include "sim/fluid/pressure/compression.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(uvec4, SlotPressures, newSlotPressures);
BUFFER(vec4, SlotWalls, newSlotWalls);
BUFFER(vec4, SlotSolids, newSlotSolids);
BUFFER(float, SlotCovered, newSlotCovered);
BUFFER(float, SlotGains, newSlotGains);
BUFFER(vec4, FluidPasts, fluidPasts);

/// What walls and solids that face each other lack.
float gainOf(WallCover walls, SolidCover solids)
{
    float side = 0.5 * solids.fraction, gain = mix(1.0, gapGain(side, side), solids.between);
    float both = length(walls.gradient) * length(solids.slope), facing = -dot(walls.gradient, solids.slope);
    float apart = clamp(facing / max(both, 1e-12), 0.0, 1.0);
    return gain * mix(1.0, gapGain(walls.fraction, solids.fraction), apart);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k);
    NeighbourCounts counts = fetchFluidCounts(k, i);
    mat3 even = fetchSlotShape(k);
    vec3 x = fetchSlotPosition(k).position;
    SlotLast last = fetchSlotLast(k);
    Own own = Own(x, x - last.position, even);
    Sums sums = sumsOver(k, counts.fluids, own);
    if (!isFluid(i)) {
        newSlotPressures[2u * k] = uvec4(floatBitsToUint(x), 0u);
        newSlotPressures[2u * k + 1u] = uvec4(0u);
        return;
    }
    SolidCover solids = solidCover(k, counts.solids, x);
    WallCover walls = wallCover(k, x);
    float gain = gainOf(walls, solids);
    walls.gradient *= gain, solids.slope *= gain;
    float covered = walls.fraction + solids.fraction, density = sums.fraction + covered;
    float excess = clamp(density - 1.0, LEAST_FLUID_ERROR, MOST_FLUID_ERROR);
#ifdef RELAX
    float compression = excess, relaxation = FLUID_START_RELAXATION;
#else
    float toWalls = dot(own.move, even * walls.gradient);
    float toSolids = dot(own.move - solids.move, evenAcross(even, solids.slope) * solids.slope);
    // Twice, as fluid_pressure pushes by them.
    float nearer = sums.nearer + 2.0 * (toWalls + toSolids);
    float carried = clamp(fluidPasts[i].w + nearer, LEAST_FLUID_ERROR, MOST_FLUID_ERROR);
    // New particles count as far as there was no room for them.
    carried = max(carried, min(carried + sums.added, excess));
    float compression = mix(carried, excess, last.isNew || density < FLUID_LOOSE ? 1.0 : FLUID_MIXING);
    float relaxation = FLUID_RELAXATION;
#endif
    fluidPasts[i].w = compression;
    vec3 all = sums.gradient + walls.gradient + solids.slope;
    // Where the slopes of solids cancel, as between two of them, there is no way out: a harder push does not help.
    // All constraints around are solved at once, each as if alone: relaxed less, they would overshoot.
    float squares = dot(all, all) + solids.opposed + sums.squares;
    float lambda = -relaxation * max(compression, 0.0) / (squares + sim.fluidSoftness);
    SlotPressure pressure = SlotPressure(x, lambda / max(fetchMass(i).inverseMass, 1e-20) * even);
    newSlotPressures[2u * k] = firstHalf(pressure);
    newSlotPressures[2u * k + 1u] = secondHalf(pressure);
    newSlotCovered[k] = covered;
    newSlotGains[k] = gain;
    newSlotWalls[k] = pack(SlotWallCover(walls.gradient, density));
    newSlotSolids[k] = pack(SlotSolidCover(solids.slope, solids.weights > 0.0 ? 1.0 / solids.weights : 0.0));
}
