// What contacts gave in the last substep [N s]. BOUNCES: of a world with restitution, which adds to it.
#include "sim/common/contacts/impulses.glsl"

uniform samplerBuffer pairImpulses;
uniform samplerBuffer colliderImpulses;
#ifdef BOUNCES
uniform samplerBuffer pairRestitutions;
uniform samplerBuffer colliderRestitutions;
#define BOUNCE(restitutions, index) fetchImpulse(restitutions, index).normal
#else
#define BOUNCE(restitutions, index) 0.0
#endif

/// Touched bodies move by first order. @param bounce what restitution adds to the normal part, or below 0 [N s].
vec3 impulseOf(Impulse solved, float bounce)
{
    vec3 impulse = solved.whole / sim.substepTime;
    return bounce > 0.0 ? impulse * (1.0 + bounce * sim.substepTime / max(solved.normal, 1e-20)) : impulse;
}

/// On the first side of a pair.
vec3 pairGave(uint index)
{
    return impulseOf(fetchImpulse(pairImpulses, index), BOUNCE(pairRestitutions, index));
}

vec3 colliderGave(uint index)
{
    return impulseOf(fetchImpulse(colliderImpulses, index), BOUNCE(colliderRestitutions, index));
}
