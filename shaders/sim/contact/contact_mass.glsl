// The inverse mass that a contact's normal impulse meets. Worked out when contacts are found, from where bodies are
// then.
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/bodies/mover_info.glsl"

uniform samplerBuffer searchRotations;

/// The inverse mass along `normal` of a mover at a particle, as a fraction of that in the worst direction: 0 ... 1. Of
/// loose particles and fixed bodies 1: the one has the same in all directions, the other never responds.
float normalFraction(uint mover, Arm arm, vec3 normal)
{
    if (mover >= sim.bodyCount || isFixed(mover)) return 1.0;
    InverseInertia inertia = fetchInverseInertia(mover);
    vec3 t = cross(arm.r, rotate(conjugate(texelFetch(searchRotations, int(mover))), normal));
    float turning = dot(t * t, inertia.diagonal) + 2.0 * dot(t.xxy * t.yzz, inertia.offDiagonal);
    return clamp((inertia.inverseMass + turning) / arm.worstInverseMass, 0.0, 1.0);
}
