// Points of foam, spray and bubbles (Ihmsen et al. 2012), which fluid carries and which change nothing of it. They
// stand in a ring: those of a step take the slots after the last ones, whatever stood there.
#include "shared/foam_ring.h"
#include "shared/state_hash.h"

struct FoamPoint {
    vec3 position;   // [m]
    float opacity;   // as it is drawn, 0 ... 1
    vec3 velocity;   // [m/s]
    float life;      // until it vanishes [s]; 0: it is not there
};

/// Where in the ring points are.
struct RingState {
    uint head;    // slot after the last point
    uint used;    // slots that have ever had a point
    uint start;   // slot of the step's first point
    uint stride;  // of the points that the fluid would make, every strideth is made
};

RingState ringStateOf(uvec4 t)
{
    return RingState(t.x, t.y, t.z, t.w);
}

/// Most points that a step makes.
uint mostBorn()
{
    return sim.foamCapacity / FOAM_BIRTHS_PART;
}

float stepTime()
{
    return float(sim.substeps) * sim.substepTime;
}

/// The speed of waves as long as particles are apart [m/s]: what is fast or slow is so beside it, at any scale.
float foamSpeed()
{
    return sqrt(max(length(sim.gravity.xyz), 0.1) * sim.fluidSpacing);
}

/// A number from 0 to 1, other each time. @param hash  Its last value; begins with anything.
float nextRandom(inout uint hash)
{
    hash = mixedHash(hash, STATE_HASH_LOW);
    return float(hash >> 8u) / 16777216.0;
}
