// One thread a slot: how many points of foam its particle makes in this step (Ihmsen et al. 2012, eqs. 2-8): where
// neighbours come at it they trap air, and wave crests take it in, both the more the faster it is. Sums over neighbours
// are means here, so that bounds are speeds and angles.
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/foam/foam_points.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer foamFlows;
uniform samplerBuffer foamFacings;
uniform samplerBuffer foamRates;        // by material
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(uint, FoamBirths, newFoamBirths);

// Least and most that counts: of the speed of neighbours towards each other, in foamSpeed(); of how much the surface
// turns; of the energy, in that of foamSpeed().
const vec2 TRAPPED = vec2(0.8, 3.0), CREST = vec2(0.25, 0.8), ENERGY = vec2(6.0, 30.0);
// Points a second that a particle makes at most.
const float TRAPPED_RATE = 160.0, CREST_RATE = 60.0;

float within(float value, vec2 bounds)
{
    return clamp((value - bounds.x) / (bounds.y - bounds.x), 0.0, 1.0);
}

/// Trapped air and wave crest, from 0 to 1.
vec2 potentials(uint k, uint count, vec3 v)
{
    vec4 facing = texelFetch(foamFacings, int(k));
    vec3 x = fetchSlotPosition(k).position;
    float inverseReach = 1.0 / sim.fluidReach, trapped = 0.0, turned = 0.0;
    vec2 weights = vec2(1e-20);
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        for (int c = 0; c < 4; ++c) {
            vec3 r = x - fetchSlotPosition(slots[c]).position, u = v - texelFetch(foamFlows, int(slots[c])).xyz;
            vec4 other = texelFetch(foamFacings, int(slots[c]));
            float apart = length(r), a = max(1.0 - apart * inverseReach, 0.0);
            // The list ends with the slot itself, which does not count.
            a = slots[c] == k ? 0.0 : a;
            trapped += a * (length(u) - dot(u, r) / max(apart, 1e-20));
            weights.x += a;
            float below = dot(r, facing.xyz) > 0.0 ? a * other.w : 0.0;
            turned += below * (1.0 - dot(facing.xyz, other.xyz));
            weights.y += below;
        }
    } while (nextTexel(texels));
    bool rises = dot(v, facing.xyz) > 0.6 * length(v) && facing.w > 0.3 && fetchSlotCover(k).fraction < 0.1;
    return vec2(within(trapped / weights.x / foamSpeed(), TRAPPED),
                rises ? within(turned / weights.y, CREST) : 0.0);
}

void main()
{
    uint k = gl_GlobalInvocationID.x, slots = slotCount();
    if (k >= slots) return;
    uint i = fetchSlotParticle(k), count = fetchFluidCounts(k, i).fluids;
    vec3 v = texelFetch(foamFlows, int(k)).xyz;
    vec2 made = potentials(k, count, v);
    float energy = within(dot(v, v) / (foamSpeed() * foamSpeed()), ENERGY);
    float rate = energy * dot(made, vec2(TRAPPED_RATE, CREST_RATE));
    rate *= texelFetch(foamRates, int(fetchSlotMaterial(k))).x;
    uint hash = mixedHash(mixedHash(STATE_HASH_HIGH, i), counters[0].substep);
    newFoamBirths[k] = isFluid(i) ? uint(rate * stepTime() + nextRandom(hash)) : 0u;
}
