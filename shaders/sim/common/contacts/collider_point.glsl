// The part of a particle that touches a collider: its ball, the corner of its box, or, of a ball or capsule, the ball
// about a point of its centre line.
#include "shared/contact_constants.h"
#include "sim/common/contacts/colliders.glsl"
#include "sim/common/contacts/contact_point.glsl"

/// From a particle to the corner of its box, in the body's axes [m]: half a diameter along each axis along which the
/// lattice ends there. A lattice of one layer ends on both sides: then the lower one counts, and neither if it stands
/// upright.
/// @param normal of the collider, in the body's axes.
vec3 boxCorner(uint ends, vec3 normal)
{
    vec3 low = vec3(uvec3(ends) >> uvec3(0, 2, 4) & 1u), high = vec3(uvec3(ends) >> uvec3(1, 3, 5) & 1u);
    vec3 lower = clamp(-normal / UPRIGHT, -1.0, 1.0);
    return 0.5 * sim.diameter * mix(high - low, lower, low * high);
}

/// @param centre, rotation of the mover. @param excess of the particle's radius [m].
Reference colliderReference(uint particle, uint mover, uint collider, float excess, vec3 centre, vec4 rotation)
{
    Reference ball = Reference(fetchArm(particle).r, particleRadius(excess), false);
    if (isRound(particle)) {
        RoundBody body = fetchRound(mover);
        return Reference(onLine(body, ball.r), body.radius, true);
    }
    uint ends = texelFetch(latticeEnds, int(particle)).x;
    // Corners that bounce would gain energy from their friction.
    if (ends == LATTICE_ENDS || ends == 0u || fetchMass(particle).restitution > 0.0) return ball;
    ColliderSurface atBall = colliderSurface(collider, centre + rotate(rotation, ball.r));
    vec3 corner = ball.r + boxCorner(ends, rotate(conjugate(rotation), atBall.normal));
    float gap = colliderSurface(collider, centre + rotate(rotation, corner)).distance;
    return gap < atBall.distance - ball.radius + CORNER_TIE * sim.diameter ? Reference(corner, 0.0, false) : ball;
}
