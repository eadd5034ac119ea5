// Density that walls and solids add in each slot; see slot_values.glsl.
#include "shared/fluid_constants.h"

uniform samplerBuffer slotWalls;
uniform samplerBuffer slotSolids;
uniform samplerBuffer slotCovers;

/// What walls and solids are around a particle.
struct SlotCover {
    float fraction;   // of the kernel, which they cover
    float gain;       // gapGain()
    float fastest;    // speed of the fastest solid nearby [m/s]; NO_SOLID
    float density;    // total density over the density at rest
};

#define NO_SOLID -1.0

SlotCover fetchSlotCover(uint slot)
{
    vec4 t = texelFetch(slotCovers, int(slot));
    return SlotCover(t.x, t.y, t.z, t.w);
}

vec4 pack(SlotCover s)
{
    return vec4(s.fraction, s.gain, s.fastest, s.density);
}

/// The highest speed that a particle may reach if it had the speed `before` and would have `now`. Being pushed out
/// between solids, or a solid and a wall, in one substep would make it as fast as that takes. It keeps the largest
/// speed that it or they had, and gets a little more.
float mostSpeed(SlotCover cover, float before, float now)
{
    float gain = MOST_SQUEEZE * sim.substepTime;
    bool free = cover.fastest == NO_SOLID || now <= before + gain;
    return free ? sim.maxSpeed : min(max(before, cover.fastest) + gain, sim.maxSpeed);
}

/// The gradient of the density constraint from walls [1/m].
vec3 fetchSlotWalls(uint slot)
{
    return texelFetch(slotWalls, int(slot)).xyz;
}

/// Density that solid particles add.
struct SlotSolidCover {
    vec3 gradient;    // of the density constraint, from solids [1/m]
    float inverseWeight;   // one over the sum of solidWeight() over them; 0: there are none
};

SlotSolidCover fetchSlotSolids(uint slot)
{
    vec4 t = texelFetch(slotSolids, int(slot));
    return SlotSolidCover(t.xyz, t.w);
}

vec4 pack(SlotSolidCover s)
{
    return vec4(s.gradient, s.inverseWeight);
}
