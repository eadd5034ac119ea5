// What the joints of a tree have been eliminated to in a substep (joint_factor).
#include "math/spatial.glsl"
#include "shared/joint_records.h"

struct JointFactor {
    Inertia inertia;   // of the body with all that hangs on it, seen from the joint
    mat3 free;         // the turn that a torque gives where the joint lets go
    vec3 arm;          // from the body's centre to the joint [m]
    vec3 parentArm;    // from its parent's
    vec3 axis;         // of a hinge
    Motion kept;       // the part of the joint's error that this substep does not take back
};

#define STORE_JOINT_FACTOR(factors, joint, f) \
    factors[JOINT_FACTOR_TEXELS * (joint)] = vec4(diagonalOf((f).inertia.a), (f).arm.x); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 1u] = vec4(offDiagonalOf((f).inertia.a), (f).arm.y); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 2u] = vec4(diagonalOf((f).inertia.d), (f).arm.z); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 3u] = vec4(offDiagonalOf((f).inertia.d), (f).parentArm.x); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 4u] = vec4((f).inertia.b[0], (f).parentArm.y); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 5u] = vec4((f).inertia.b[1], (f).parentArm.z); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 6u] = vec4((f).inertia.b[2], (f).axis.x); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 7u] = vec4(diagonalOf((f).free), (f).axis.y); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 8u] = vec4(offDiagonalOf((f).free), (f).axis.z); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 9u].xyz = (f).kept.t; \
    factors[JOINT_FACTOR_TEXELS * (joint) + 10u].xyz = (f).kept.r;

/// From texels that GET(0), GET(1) ... give.
#define JOINT_KEPT_FROM(GET) Motion(GET(9).xyz, GET(10).xyz)
#define JOINT_FACTOR_FROM(GET) \
    JointFactor(Inertia(symmetricMatrix(GET(0).xyz, GET(1).xyz), mat3(GET(4).xyz, GET(5).xyz, GET(6).xyz), \
                        symmetricMatrix(GET(2).xyz, GET(3).xyz)), \
                symmetricMatrix(GET(7).xyz, GET(8).xyz), vec3(GET(0).w, GET(1).w, GET(2).w), \
                vec3(GET(3).w, GET(4).w, GET(5).w), vec3(GET(6).w, GET(7).w, GET(8).w), \
                JOINT_KEPT_FROM(GET))

/// Of a body that nothing holds, how it answers with all that hangs on it.
#define STORE_ROOT_RESPONSE(responses, joint, w) \
    responses[ROOT_RESPONSE_TEXELS * (joint)] = vec4(diagonalOf((w).a), (w).b[2].x); \
    responses[ROOT_RESPONSE_TEXELS * (joint) + 1u] = vec4(offDiagonalOf((w).a), (w).b[2].y); \
    responses[ROOT_RESPONSE_TEXELS * (joint) + 2u] = vec4(diagonalOf((w).d), (w).b[2].z); \
    responses[ROOT_RESPONSE_TEXELS * (joint) + 3u].xyz = offDiagonalOf((w).d); \
    responses[ROOT_RESPONSE_TEXELS * (joint) + 4u].xyz = (w).b[0]; \
    responses[ROOT_RESPONSE_TEXELS * (joint) + 5u].xyz = (w).b[1];

#define ROOT_RESPONSE_FROM(GET) \
    Response(symmetricMatrix(GET(0).xyz, GET(1).xyz), \
             mat3(GET(4).xyz, GET(5).xyz, vec3(GET(0).w, GET(1).w, GET(2).w)), \
             symmetricMatrix(GET(2).xyz, GET(3).xyz))
