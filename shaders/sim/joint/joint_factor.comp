// One thread a tree of joints: from the leaves to the root each body, with all that hangs on it, is seen from its joint,
// which passes on what it does not let go (Featherstone 2008, articulated bodies). Once a substep; joint_solve makes use
// of it. RESPONSES: of a world where something asks how bodies answer to forces. LIMITS: of one where joints are limited;
// AGAIN: later in a substep, where other limits hold than before.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/body_loads.glsl"
#include "sim/joint/joint_factors.glsl"
#include "sim/joint/joint_pose.glsl"
#include "sim/joint/joint_left.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
#ifdef LIMITS
#include "sim/joint/joint_stop_update.glsl"
#endif
BUFFER(vec4, JointFactors, jointFactors);
BUFFER(vec4, JointPassed, jointPassed);

/// The turn that a torque gives in the directions that the joint leaves free.
mat3 freeTurning(mat3 d, uint freedom, vec3 axis)
{
    if (freedom == JOINT_BALL) return inverse(d);
    return freedom == JOINT_HINGE ? outerProduct(axis, axis) / dot(axis, d * axis) : mat3(0);
}

Inertia loadPassed(uint joint)
{
    uint first = JOINT_PASSED * joint;
    vec4 t[JOINT_PASSED];
    for (int k = 0; k < int(JOINT_PASSED); ++k) t[k] = jointPassed[first + uint(k)];
    return Inertia(symmetricMatrix(t[0].xyz, t[1].xyz), mat3(t[4].xyz, t[5].xyz, vec3(t[0].w, t[1].w, t[2].w)),
                   symmetricMatrix(t[2].xyz, t[3].xyz));
}

void storePassed(uint joint, Inertia m)
{
    uint first = JOINT_PASSED * joint;
    jointPassed[first] = vec4(diagonalOf(m.a), m.b[2].x);
    jointPassed[first + 1u] = vec4(offDiagonalOf(m.a), m.b[2].y);
    jointPassed[first + 2u] = vec4(diagonalOf(m.d), m.b[2].z);
    jointPassed[first + 3u].xyz = offDiagonalOf(m.d);
    jointPassed[first + 4u].xyz = m.b[0];
    jointPassed[first + 5u].xyz = m.b[1];
}

void factor(uint k)
{
    TreeJoint joint = fetchTreeJoint(k);
    JointRows rows = fetchJointRows(k);
    Inertia m = Inertia(mat3(1.0 / fetchMover(joint.body).inverseMass), mat3(0), fetchBodyLoad(joint.body).hessian);
    for (uint child = rows.firstChild; child < rows.childEnd; ++child) m = add(m, loadPassed(child));
    JointFactor f = JointFactor(m, mat3(0), vec3(0), vec3(0), vec3(0), Motion(vec3(0), vec3(0)));
    if (joint.freedom != JOINT_NONE) {
        JointSide body = jointSide(k, 0u, joint.body), parent = jointSide(k, 1u, joint.parent);
        vec3 axis = rotate(body.frame, vec3(1, 0, 0));
        m = shifted(m, body.arm);
        mat3 d = m.d;
#ifdef LIMITS
        d += hardened(k, d);
#endif
        mat3 g = freeTurning(d, joint.freedom, axis);
        f = JointFactor(m, g, body.arm, parent.arm, axis, leftOf(startError(body, parent, joint.freedom)));
        mat3 gb = g * m.b, gd = g * m.d;
        storePassed(k, shifted(Inertia(m.a - transpose(m.b) * gb, m.b - m.d * gb, m.d - m.d * gd), -parent.arm));
    }
    if (joint.freedom == JOINT_NONE) {
        Response w = inverseOf(m);
        f.inertia = Inertia(w.a, w.b, w.d);
    }
    STORE_JOINT_FACTOR(jointFactors, k, f)
}

#ifdef RESPONSES
#include "sim/joint/joint_responses.glsl"
#endif

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (isAsleep(fetchMover(fetchTreeJoint(tree.first).body).assembly)) return;
#ifdef LIMITS
#ifdef AGAIN
    if (!updateStops(tree, false)) return;
#else
    updateStops(tree, true);
#endif
#endif
    for (uint k = tree.end; k-- > tree.first;) factor(k);
#ifdef RESPONSES
    for (uint k = tree.first; k < tree.end; ++k) respond(k);
#endif
}
