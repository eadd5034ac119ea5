// Velocities of points of movers, now and when they met.
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_state.glsl"
#include "sim/common/outside.glsl"

uniform samplerBuffer oldMoverMoves;
uniform samplerBuffer oldMoverVelocities;
uniform samplerBuffer moverSolvedVelocities;

/// The angular velocity of a velocity field whose body's axes have turned to `axes`. The field is a chord, which points
/// inwards by half a substep's turn: its size is that of the turn, its axis that of its antisymmetric part.
vec3 spinOf(mat3 f, mat3 axes)
{
    vec3 turn = cross(axes[0], f[0]) + cross(axes[1], f[1]) + cross(axes[2], f[2]);
    float size = sqrt(0.5 * (dot(f[0], f[0]) + dot(f[1], f[1]) + dot(f[2], f[2])));
    return turn * (size / max(length(turn), 1e-20));
}

/// Velocity of a mover's point, turned as it is now [m/s].
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

/// Velocity after the substep's solve, before anything bounced [m/s].
vec3 velocitySolved(uint mover, vec3 r)
{
    return pointVelocity(fetchField(moverSolvedVelocities, mover), mover, r);
}

/// How a mover's point would have met a contact, and its way there.
struct Arrival {
    vec3 velocity;   // before the substep, of the body turned as it is now [m/s]
    vec3 way;        // in the substep [m]
    vec3 pull;       // acceleration if nothing holds it [m/s2]
};

Arrival arrivalOf(uint mover, vec3 r)
{
    if (!moves(mover)) return Arrival(vec3(0), vec3(0), vec3(0));
    Field move = fetchField(oldMoverMoves, mover);
    return Arrival(pointVelocity(fetchField(oldMoverVelocities, mover), mover, r), move.t + move.f * r,
                   responds(mover) ? outsideAcceleration(mover) : vec3(0));
}

/// The speed at which two points meet [m/s]: accelerations add to it on the way, v^2 = v0^2 + 2 g s.
float approachOf(Arrival a, Arrival b, vec3 normal)
{
    float speed = -dot(normal, a.velocity - b.velocity);
    float gained = 2.0 * dot(normal, a.pull - b.pull) * dot(normal, a.way - b.way);
    return speed > 0.0 ? sqrt(max(speed * speed + gained, 0.0)) : 0.0;
}
