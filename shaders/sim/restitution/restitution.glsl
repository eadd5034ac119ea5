// Restitution, after a substep: an impulse gives each collision the speed of separation that it owes to the speed of
// approach before the substep (Mueller et al. 2020, "Detailed Rigid Body Simulation with Extended Position Based
// Dynamics", 3.6). DETECT: only notes which contacts collide, so that they can be counted. EAGER: every other iteration
// takes longer steps, for collisions that share a body's work well; a single one is done after the first.
#include "sim/common/mover_state.glsl"

uniform samplerBuffer oldMoverVelocities;
uniform samplerBuffer moverRestitutionSplits;      // over how many impulses a mover's mass is split

/// Velocity of a mover's point before the substep [m/s].
vec3 velocityBefore(uint mover, vec3 r)
{
    Field v = fetchField(oldMoverVelocities, mover);
    return v.t + v.f * r;
}

/// What this iteration adds to an impulse, in xyz; w: all of it, or ABOUT_TO_ACT where it is yet to come.
/// @param last what was added before. @param impulse the contact's normal impulse in the substep.
/// @param before, now relative velocities [m/s]. @param inverseMass of both sides, each split over its impulses.
vec4 solveRestitution(vec4 last, float impulse, vec3 normal, vec3 before, vec3 now, float inverseMass, float restitution)
{
    float approach = -dot(normal, before);
#ifdef DETECT
    bool collides = restitution > 0.0 && impulse > 0.0 && approach > sim.restitutionThreshold;
    return vec4(0, 0, 0, collides ? ABOUT_TO_ACT : 0.0);
#else
    if (last.w == 0.0) return vec4(0);
#ifdef EAGER
    inverseMass /= 1.8;
#endif
    float so = max(last.w, 0.0);
    float whole = max(so + (restitution * approach - dot(normal, now)) / inverseMass, 0.0);
    return vec4((whole - so) * normal, whole > 0.0 ? whole : ABOUT_TO_ACT);
#endif
}
