// The inverse mass that a contact's normal impulse meets, as a share of the worst direction's (restOffsets[].w). Worked
// out when contacts are found, from where bodies are then.
#include "math/quaternion.glsl"

uniform samplerBuffer searchRotations;
uniform samplerBuffer bodyInertias;      // two a body, inverse: xx, yy, zz, 1 / mass; xy, xz, yz

/// @param arm the particle's place in the body; w: the inverse mass of the worst direction there.
float normalFraction(uint mover, vec4 arm, vec3 normal)
{
    if (mover >= sim.bodyCount || arm.w == 0.0) return 1.0;
    vec4 diagonal = texelFetch(bodyInertias, int(2u * mover));
    vec3 other = texelFetch(bodyInertias, int(2u * mover + 1u)).xyz;
    vec3 t = cross(arm.xyz, rotate(conjugate(texelFetch(searchRotations, int(mover))), normal));
    float turning = dot(t * t, diagonal.xyz) + 2.0 * dot(t.xxy * t.yzz, other);
    return clamp((diagonal.w + turning) / arm.w, 0.0, 1.0);
}
