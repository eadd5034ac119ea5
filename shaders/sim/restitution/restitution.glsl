// Restitution, after a substep: an impulse gives each collision the speed of separation that it owes to the speed of
// approach before the substep (Mueller et al. 2020, "Detailed Rigid Body Simulation with Extended Position Based
// Dynamics", 3.6). DETECT: only notes which contacts collide, so that they can be counted. EAGER: every other iteration
// takes longer steps. They suit collisions of which a body has many; a single one is done after the first iteration.
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/bodies/mover_state.glsl"

uniform samplerBuffer oldMoverVelocities;
uniform samplerBuffer moverRestitutionSplits;

/// Over how many impulses a mover's mass is split; 0: it does not respond.
float restitutionSplits(uint mover)
{
    return texelFetch(moverRestitutionSplits, int(mover)).x;
}

/// Velocity of a mover's point before the substep [m/s].
vec3 velocityBefore(uint mover, vec3 r)
{
    Field v = fetchField(oldMoverVelocities, mover);
    return v.t + v.f * r;
}

/// The impulse of a contact after this iteration: `whole` is what it adds, `normal` all that there is so far, or
/// ABOUT_TO_ACT where it is yet to come.
/// @param last after the iteration before. @param impulse the contact's normal impulse in the substep [kg m].
/// @param before, now relative velocities [m/s].
/// @param inverseMass of both sides, each split over its impulses [1/kg].
Impulse solveRestitution(Impulse last, float impulse, vec3 normal, vec3 before, vec3 now, float inverseMass,
                         float restitution)
{
    float approach = -dot(normal, before);
#ifdef DETECT
    bool collides = restitution > 0.0 && impulse > 0.0 && approach > sim.restitutionThreshold;
    return Impulse(vec3(0), collides ? ABOUT_TO_ACT : 0.0);
#else
    if (last.normal == 0.0) return Impulse(vec3(0), 0.0);
#ifdef EAGER
    inverseMass /= 1.8;
#endif
    float sum = max(last.normal, 0.0);
    float whole = max(sum + (restitution * approach - dot(normal, now)) / inverseMass, 0.0);
    return Impulse((whole - sum) * normal, whole > 0.0 ? whole : ABOUT_TO_ACT);
#endif
}
