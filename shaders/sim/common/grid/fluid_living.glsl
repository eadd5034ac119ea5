// How many particles have a slot: all solid ones and the active fluid ones. POOL: a world with emitters or drains.
// There w of a fluid particle's position says whether it is inactive, and w of its velocity how long it keeps that
// velocity: more fluid, which no particles stand for, follows a particle that has just left a nozzle.

/// Room for slots.
uint slotCapacity()
{
    return sim.particleCount + sim.fluidCount;
}

#ifdef POOL
uniform usamplerBuffer fluidTotals;      // fluid particles that came from emitters, that left
#define INACTIVE 1.0

uint slotCount()
{
    uvec2 totals = texelFetch(fluidTotals, 0).xy;
    return sim.particleCount + sim.fluidFilled + totals.x - totals.y;
}
#else
uint slotCount()
{
    return slotCapacity();
}
#endif

/// Whether a fluid particle at that place is inactive.
bool isInactive(vec4 place)
{
#ifdef POOL
    return place.w == INACTIVE;
#else
    return false;
#endif
}

/// How long a particle of this velocity is still held [s].
float timeHeld(vec4 velocity)
{
#ifdef POOL
    return velocity.w;
#else
    return 0.0;
#endif
}
