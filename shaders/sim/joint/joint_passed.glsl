// What joint_factor hands from a joint's body to its parent: the inertia that the parent sees of it. A kernel that
// stores it declares BUFFER(vec4, JointPassed, jointPassed).
#include "math/spatial.glsl"
#include "shared/joint_records.h"

Inertia loadPassed(uint joint)
{
    uint first = JOINT_PASSED_TEXELS * joint;
    vec4 t[JOINT_PASSED_TEXELS];
    for (int k = 0; k < JOINT_PASSED_TEXELS; ++k) t[k] = jointPassed[first + uint(k)];
    return Inertia(symmetricMatrix(t[0].xyz, t[1].xyz), mat3(t[4].xyz, t[5].xyz, vec3(t[0].w, t[1].w, t[2].w)),
                   symmetricMatrix(t[2].xyz, t[3].xyz));
}

void storePassed(uint joint, Inertia m)
{
    uint first = JOINT_PASSED_TEXELS * joint;
    jointPassed[first] = vec4(diagonalOf(m.a), m.b[2].x);
    jointPassed[first + 1u] = vec4(offDiagonalOf(m.a), m.b[2].y);
    jointPassed[first + 2u] = vec4(diagonalOf(m.d), m.b[2].z);
    jointPassed[first + 3u].xyz = offDiagonalOf(m.d);
    jointPassed[first + 4u].xyz = m.b[0];
    jointPassed[first + 5u].xyz = m.b[1];
}
