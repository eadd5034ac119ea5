// Where bodies were when the substep began.
#include "math/quaternion.glsl"

uniform samplerBuffer bodyStarts;

struct BodyStart {
    vec3 centre;      // [m]
    vec4 rotation;
};

BodyStart fetchBodyStart(uint b)
{
    return BodyStart(texelFetch(bodyStarts, int(2u * b)).xyz, texelFetch(bodyStarts, int(2u * b + 1u)));
}

/// Stores one; a macro, as GLSL passes no arrays of unknown size.
#define STORE_BODY_START(starts, b, start) \
    starts[2u * b] = vec4((start).centre, 0); \
    starts[2u * b + 1u] = (start).rotation
