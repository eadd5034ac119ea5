// Restitution, after a substep: an impulse gives each collision the speed of separation that it owes to the speed of
// approach before the substep (Mueller et al. 2020, "Detailed Rigid Body Simulation with Extended Position Based
// Dynamics", 3.6). DETECT: only notes which contacts collide, so that they can be counted. EAGER: every other iteration
// takes longer steps. They suit collisions of which a body has many; a single one is done after the first iteration.
// LEDGER: what the impulses give and cost of energy. SHARE: scales them to what the movers can afford.
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_state.glsl"

uniform samplerBuffer oldMoverMoves;
uniform samplerBuffer oldMoverVelocities;
uniform samplerBuffer moverRestitutionSplits;
uniform samplerBuffer moverRestitutionShares;
uniform samplerBuffer moverSolvedVelocities;

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

/// The angular velocity of a velocity field, of axes turned about as far as these. The field is a chord, which points
/// inwards by half a substep's turn: its size is that of the turn, its axis that of its antisymmetric part.
vec3 spinOf(mat3 f, mat3 axes)
{
    vec3 turn = cross(axes[0], f[0]) + cross(axes[1], f[1]) + cross(axes[2], f[2]);
    float size = sqrt(0.5 * (dot(f[0], f[0]) + dot(f[1], f[1]) + dot(f[2], f[2])));
    return turn * (size / max(length(turn), 1e-20));
}

/// Of a mover's point, turned as it is now [m/s].
vec3 pointVelocity(Field velocity, uint mover, vec3 r)
{
    if (!IS_BODY(mover)) return velocity.t;
    mat3 axes = matrixFromQuaternion(fetchRotation(mover));
    return velocity.t + cross(spinOf(velocity.f, axes), axes * r);
}

vec3 velocityNow(uint mover, vec3 r)
{
    return pointVelocity(fetchField(moverVelocities, mover), mover, r);
}

/// After the substep's solve, before anything bounced [m/s].
vec3 velocitySolved(uint mover, vec3 r)
{
    return pointVelocity(fetchField(moverSolvedVelocities, mover), mover, r);
}

/// How a mover's point would have met a contact, and how it came there.
struct Arrival {
    vec3 velocity;   // before the substep, of the body turned as it is now [m/s]
    vec3 way;        // in the substep [m]
    vec3 pull;       // acceleration of what nothing holds [m/s2]
};

Arrival arrivalOf(uint mover, vec3 r)
{
    if (!moves(mover)) return Arrival(vec3(0), vec3(0), vec3(0));
    Field move = fetchField(oldMoverMoves, mover);
    return Arrival(pointVelocity(fetchField(oldMoverVelocities, mover), mover, r), move.t + move.f * r,
                   responds(mover) ? sim.gravity.xyz : vec3(0));
}

/// The speed at which two meet [m/s]: gravity speeds them up on their way there, v^2 = v0^2 + 2 g s.
float approachOf(Arrival a, Arrival b, vec3 normal)
{
    float speed = -dot(normal, a.velocity - b.velocity);
    float gained = 2.0 * dot(normal, a.pull - b.pull) * dot(normal, a.way - b.way);
    return speed > 0.0 ? sqrt(max(speed * speed + gained, 0.0)) : 0.0;
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
