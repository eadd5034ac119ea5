// Restitution, after a substep: an impulse gives each collision its speed of separation, by the speed of approach
// before the substep (Mueller et al. 2020, "Detailed Rigid Body Simulation with Extended Position Based Dynamics",
// 3.6). DETECT: only notes which contacts collide, so that they can be counted. EAGER: every other iteration takes
// longer steps. They suit bodies with many collisions; a single collision is done after the first iteration. LEDGER:
// energy that the impulses give and cost. SHARE: scales them to what the movers can afford.
#include "sim/common/contacts/contacts.glsl"
#include "sim/restitution/arrival.glsl"
#include "sim/restitution/blows.glsl"

uniform samplerBuffer moverRestitutionSplits;
uniform samplerBuffer moverRestitutionShares;

/// Number of impulses over which a mover's mass is split; 0: it does not collide.
float restitutionSplits(uint mover)
{
    return texelFetch(moverRestitutionSplits, int(mover)).x;
}

/// The shares that a mover can afford of its impulses here and of the solver's, 0 ... 1.
vec2 restitutionShares(uint mover)
{
    return !responds(mover) ? vec2(1) : texelFetch(moverRestitutionShares, int(mover)).xy;
}

/// The energy that a part s of a contact's impulse adds to each side: s linear + s^2 square [J]. If one side does not
/// respond, the other gets all of it, else half.
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

/// The impulse of a contact after this iteration: `whole` is what it adds, `normal` the sum so far, or ABOUT_TO_ACT if
/// it is yet to come.
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
    if (last.normal == 0.0 || last.normal == TAKEN_BACK) return Impulse(vec3(0), last.normal);
#ifdef EAGER
    inverseMass /= 1.8;
#endif
    float sum = max(last.normal, 0.0);
    float whole = max(sum + (restitution * approach - dot(normal, now)) / inverseMass, 0.0);
    return Impulse((whole - sum) * normal, whole > 0.0 ? whole : ABOUT_TO_ACT);
#endif
}
