// How many particles have a slot: the solid ones and the fluid ones that are there. POOL: a world with emitters or
// drains, where fluid particles may be inactive, which their positions' w says, and keep their velocity for as long as
// their velocities' w says: what has just left a nozzle has more of its fluid behind it, which no particles stand for.

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

/// Whether a fluid particle at that place is none.
bool isInactive(vec4 place)
{
#ifdef POOL
    return place.w == INACTIVE;
#else
    return false;
#endif
}

/// For how long a particle of this velocity is still held [s].
float timeHeld(vec4 velocity)
{
#ifdef POOL
    return velocity.w;
#else
    return 0.0;
#endif
}
