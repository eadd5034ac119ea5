// Restitution, after a substep: an impulse gives each collision the speed of separation that it owes to the speed of
// approach before the substep (Mueller et al. 2020, "Detailed Rigid Body Simulation with Extended Position Based
// Dynamics", 3.6). DETECT: only notes which contacts collide, so that they can be counted. EAGER: every other iteration
// takes longer steps. They suit collisions of which a body has many; a single one is done after the first iteration.
// LEDGER: what the impulses give and cost of energy. SHARE: scales them to what the movers can afford.
#include "sim/common/contacts/contacts.glsl"
#include "sim/restitution/arrival.glsl"

uniform samplerBuffer moverRestitutionSplits;
uniform samplerBuffer moverRestitutionShares;

/// Over how many impulses a mover's mass is split; 0: it does not respond.
float restitutionSplits(uint mover)
{
    return texelFetch(moverRestitutionSplits, int(mover)).x;
}

/// The shares that a mover can afford of its impulses here and of the solver's, 0 ... 1.
vec2 restitutionShares(uint mover)
{
    return !responds(mover) ? vec2(1) : texelFetch(moverRestitutionShares, int(mover)).xy;
}

/// What a contact's impulse does to the energy of its sides, s of it: s linear + s^2 square [J]. With a side that does
/// not respond all of it is the other's, else half of it.
/// @param impulse [kg m/s]. @param solved, now relative velocities along the normal, without the impulses and with.
vec2 gainOf(float impulse, float solved, float now, float part)
{
    return part * impulse * vec2(solved, 0.5 * (now - solved));
}

/// Scales a contact's impulses. @param solver that of the substep's solve [kg m/s].
Impulse sharedRestitution(Impulse last, vec3 normal, vec3 solver, vec2 shares)
{
    float sum = max(last.normal, 0.0);
    return Impulse((shares.x - 1.0) * sum * normal + (shares.y - 1.0) * solver, shares.x * sum);
}

/// The impulse of a contact after this iteration: `whole` is what it adds, `normal` all that there is so far, or
/// ABOUT_TO_ACT where it is yet to come.
/// @param last after the iteration before. @param impulse the contact's normal impulse in the substep [kg m].
/// @param approach before the substep. @param now relative velocity [m/s].
/// @param inverseMass of both sides, each split over its impulses [1/kg].
Impulse solveRestitution(Impulse last, float impulse, vec3 normal, float approach, vec3 now, float inverseMass,
                         float restitution)
{
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
