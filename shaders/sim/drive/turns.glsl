// Turns as vectors, and how far a body is turned away from its clip.
#include "math/quaternion.glsl"

/// The turn of a quaternion, at most a half turn [rad].
vec3 turnOfQuaternion(vec4 q)
{
    if (q.w < 0.0) q = -q;
    float s = length(q.xyz);
    return (s > 1e-7 ? 2.0 * atan(s, q.w) / s : 2.0) * q.xyz;
}

/// The turn from one rotation to another.
vec3 turnBetween(vec4 from, vec4 to)
{
    return turnOfQuaternion(quaternionProduct(to, conjugate(from)));
}

/// By how much a body differs from its clip, in the axes of its parent. @param target the clip, against the parent.
vec4 turnFrom(vec4 target, vec4 parent, vec4 body)
{
    return quaternionProduct(quaternionProduct(conjugate(parent), body), conjugate(target));
}
