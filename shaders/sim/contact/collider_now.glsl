// A contact of a particle with a collider where an iteration has both.
#include "sim/common/bodies/movers.glsl"
#include "sim/common/contacts/collider_moves.glsl"
#include "sim/common/contacts/collider_point.glsl"

struct ColliderNow {
    Reference ref;
    MoverPoint point;     // of the reference
    vec3 normal;
    vec3 offset;          // from the reference to where the surfaces meet [m]
    vec3 surfaceWay;      // of the collider there [m]
    float gap, startGap;  // now, and at the start of the substep [m]
};

/// @param excess of the particle's radius [m]. @param rotation of the mover now.
ColliderNow colliderNow(uint particle, uint mover, uint collider, float excess, vec4 rotation)
{
    ColliderNow now;
    now.ref = colliderReference(particle, mover, collider, excess, fetchCentre(mover), rotation);
    now.point = moverPoint(mover, now.ref.r);
    vec3 start = now.point.centre + now.point.arm;
    ColliderSurface surface = colliderSurface(collider, start + now.point.move);
    now.normal = surface.normal;
    now.offset = -now.ref.radius * surface.normal;
    now.surfaceWay = surfaceMove(collider, start + now.point.move + now.offset);
    now.gap = surface.distance - now.ref.radius;
    now.startGap = colliderSurface(collider, takenAlong(collider, start)).distance - now.ref.radius;
    return now;
}
