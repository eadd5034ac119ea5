// One thread a tree of joints: from the leaves to the root each body, with all that hangs on it, is seen from its
// joint, which passes on what it does not let go (Featherstone 2008, articulated bodies). Once a substep; joint_solve
// makes use of it. RESPONSES: of a world where something asks how bodies answer to forces. LIMITS: of one where joints
// are limited; AGAIN: later in a substep, where other limits hold than before.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/body_loads.glsl"
#include "sim/joint/joint_factors.glsl"
#include "sim/joint/joint_pose.glsl"
#include "sim/joint/joint_recovery.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
#ifdef LIMITS
#include "sim/joint/joint_stop_update.glsl"
#endif
BUFFER(vec4, JointFactors, jointFactors);
BUFFER(vec4, RootResponses, rootResponses);
BUFFER(vec4, JointPassed, jointPassed);
#include "sim/joint/joint_passed.glsl"

/// The turn that a torque gives in the directions that the joint leaves free.
mat3 freeTurning(mat3 d, uint freedom, vec3 axis)
{
    if (freedom == JOINT_BALL) return inverse(d);
    return freedom == JOINT_HINGE ? outerProduct(axis, axis) / dot(axis, d * axis) : mat3(0);
}

/// What hangs on a body that does not respond is held by it.
void factor(uint k)
{
    JointInfo joint = fetchJoint(k);
    uint freedom = fetchFreedom(k);
    bool free = responds(joint.body);
    Inertia m = Inertia(mat3(1.0 / fetchMover(joint.body).inverseMass), mat3(0), fetchBodyLoad(joint.body).hessian);
    for (uint child = joint.firstChild; child < joint.childEnd; ++child) m = add(m, loadPassed(child));
    Inertia passed = Inertia(mat3(0), mat3(0), mat3(0));
    if (free && freedom == JOINT_NONE) {
        Response w = inverseOf(m);
        STORE_ROOT_RESPONSE(rootResponses, k, w)
    }
    if (free && freedom != JOINT_NONE) {
        JointSide body = jointSide(k, 0u, joint.body), parent = jointSide(k, 1u, joint.parent);
        vec3 axis = rotate(body.frame, vec3(1, 0, 0));
        m = shifted(m, body.arm);
        mat3 d = m.d;
#ifdef LIMITS
        d += stopStiffness(k, d);
#endif
        mat3 g = freeTurning(d, freedom, axis);
        JointFactor f = JointFactor(m, g, body.arm, parent.arm, axis, keptOf(startError(body, parent, freedom)));
        STORE_JOINT_FACTOR(jointFactors, k, f)
        mat3 gb = g * m.b, gd = g * m.d;
        passed = shifted(Inertia(m.a - transpose(m.b) * gb, m.b - m.d * gb, m.d - m.d * gd), -parent.arm);
    }
    storePassed(k, passed);
}

#ifdef RESPONSES
#include "sim/joint/joint_responses.glsl"
#endif

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (treeRests(tree)) return;
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
