// One thread a slot, a few times a step: how uneven the fluid around a particle is. The kernel's sums over neighbours
// that lean would give it a stress that is not the same in all directions, so that fluid under pressure rubs like sand;
// the inverse of M = sum V r grad W (Randles and Libersky 1996) evens it. M changes as slowly as the fluid shears.
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/pressure/slot_pressures.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/fluid/neighbour_moments.glsl"
#include "sim/fluid/walls/fluid_colliders.glsl"
#include "sim/fluid/walls/solid_cover.glsl"
#include "sim/fluid/walls/wall_cover.glsl"

layout(local_size_x = GROUP_SIZE) in;
FLOAT_TEXELS(newSlotShapes)

/// The size of the difference to 1 beyond which what evens is scaled down.
const float MOST_UNEVEN = 4.0;

Moments momentsOver(uint k, uint count, vec3 x)
{
    Moments sums = noMoments(count);
    float inverseReach = 1.0 / sim.fluidReach;
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        for (int c = 0; c < 4; ++c) addMoment(sums, x - fetchSlotPosition(slots[c]).position, inverseReach);
    } while (nextTexel(texels));
    return sums;
}

/// The inverse of M. Of a few particles in a line or a plane it would be anything: it stays near 1.
mat3 boundedInverse(mat3 moment)
{
    if (determinant(moment) < 0.01) return mat3(1.0);
    mat3 even = inverse(moment), beyond = even - mat3(1.0);
    float size = sqrt(dot(beyond[0], beyond[0]) + dot(beyond[1], beyond[1]) + dot(beyond[2], beyond[2]));
    return size > MOST_UNEVEN ? mat3(1.0) + MOST_UNEVEN / size * beyond : even;
}

/// What evens the stress. Behind walls and solids, and where nothing is, fluid is taken to go on evenly.
mat3 evened(Moments sums, SolidCover solids, WallCover walls)
{
    float fraction = sim.fluidVolume * sums.fraction;
    mat3 moment = momentMatrix(sums) + walls.moment + solids.moment;
    moment += mat3(walls.fraction + solids.fraction + max(1.0 - fraction - walls.fraction - solids.fraction, 0.0));
    // What rubs along a body would hold it.
    float part = mix(FLUID_EVENNESS, 1.0, smoothstep(0.0, 0.05, solids.fraction));
    return mat3(1.0 - part) + part * boundedInverse(moment);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k);
    if (!isFluid(i)) return;
    NeighbourCounts counts = fetchFluidCounts(k, i);
    vec3 x = fetchSlotPosition(k).position;
    Moments sums = momentsOver(k, counts.fluids, x);
    SolidCover solids = solidCover(k, counts.solids, x);
    WallCover walls = wallCover(k, x);
    mat3 even = evened(sums, solids, walls);
    imageStore(newSlotShapes, int(2u * k), vec4(even[0], 0));
    imageStore(newSlotShapes, int(2u * k + 1u), vec4(even[1].yz, even[2].z, 0));
}
