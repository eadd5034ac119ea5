// Factors of the joints of a tree in a substep (joint_factor).
#include "math/spatial_solve.glsl"
#include "shared/joint_records.h"

struct JointFactor {
    Inertia inertia;   // of the body with all that hangs on it, seen from the joint
    Cholesky free;     // of a ball's resistance to free turns; for a hinge only its first pivot, about the axis
    vec3 arm;          // from the body's centre to the joint [m]
    vec3 parentArm;    // from its parent's
    vec3 axis;         // of a hinge
    Motion kept;       // the part of the joint's error that this substep does not correct
};

#define STORE_JOINT_FACTOR(factors, joint, f) \
    factors[JOINT_FACTOR_TEXELS * (joint)] = vec4(diagonalOf((f).inertia.a), (f).arm.x); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 1u] = vec4(offDiagonalOf((f).inertia.a), (f).arm.y); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 2u] = vec4(diagonalOf((f).inertia.d), (f).arm.z); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 3u] = vec4(offDiagonalOf((f).inertia.d), (f).parentArm.x); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 4u] = vec4((f).inertia.b[0], (f).parentArm.y); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 5u] = vec4((f).inertia.b[1], (f).parentArm.z); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 6u] = vec4((f).inertia.b[2], (f).axis.x); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 7u] = vec4((f).free.inversePivots, (f).axis.y); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 8u] = vec4((f).free.lower, (f).axis.z); \
    factors[JOINT_FACTOR_TEXELS * (joint) + 9u].xyz = (f).kept.t; \
    factors[JOINT_FACTOR_TEXELS * (joint) + 10u].xyz = (f).kept.r;

/// From texels that GET(0), GET(1) ... give.
#define JOINT_KEPT_FROM(GET) Motion(GET(9).xyz, GET(10).xyz)
#define JOINT_FACTOR_FROM(GET) \
    JointFactor(Inertia(symmetricMatrix(GET(0).xyz, GET(1).xyz), mat3(GET(4).xyz, GET(5).xyz, GET(6).xyz), \
                        symmetricMatrix(GET(2).xyz, GET(3).xyz)), \
                Cholesky(GET(7).xyz, GET(8).xyz), vec3(GET(0).w, GET(1).w, GET(2).w), \
                vec3(GET(3).w, GET(4).w, GET(5).w), vec3(GET(6).w, GET(7).w, GET(8).w), \
                JOINT_KEPT_FROM(GET))

/// The turn that a torque gives where the joint lets go.
vec3 freeTurn(JointFactor f, uint freedom, vec3 torque)
{
    if (freedom == JOINT_BALL) return solve(f.free, torque);
    return freedom == JOINT_HINGE ? f.free.inversePivots.x * dot(f.axis, torque) * f.axis : vec3(0);
}

/// Factors of a body that nothing holds, with all that hangs on it.
#define STORE_ROOT_FACTOR(factors, joint, m) \
    factors[ROOT_FACTOR_TEXELS * (joint)] = vec4((m).turn.inversePivots, (m).b[2].x); \
    factors[ROOT_FACTOR_TEXELS * (joint) + 1u] = vec4((m).turn.lower, (m).b[2].y); \
    factors[ROOT_FACTOR_TEXELS * (joint) + 2u] = vec4((m).move.inversePivots, (m).b[2].z); \
    factors[ROOT_FACTOR_TEXELS * (joint) + 3u].xyz = (m).move.lower; \
    factors[ROOT_FACTOR_TEXELS * (joint) + 4u].xyz = (m).b[0]; \
    factors[ROOT_FACTOR_TEXELS * (joint) + 5u].xyz = (m).b[1];

#define ROOT_FACTOR_FROM(GET) \
    FactoredInertia(Cholesky(GET(0).xyz, GET(1).xyz), Cholesky(GET(2).xyz, GET(3).xyz), \
                    mat3(GET(4).xyz, GET(5).xyz, vec3(GET(0).w, GET(1).w, GET(2).w)))
