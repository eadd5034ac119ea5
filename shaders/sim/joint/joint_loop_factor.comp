// One thread a tree of joints: of its joints that close loops, how far their ends move apart for each force between them
// that they can have. After joint_factor, once a substep.
#include "sim/common/kernel.glsl"
#include "sim/joint/joint_pose.glsl"
#include "sim/joint/joint_sweeps.glsl"
#include "sim/joint/joint_loops.glsl"
#include "sim/joint/joint_left.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
BUFFER(vec4, JointFactors, newJointFactors);

/// Keeps a loop regular that the tree holds already in some direction.
const float REGULAR = 1e-4;

mat3 regular(mat3 m)
{
    return m + mat3(REGULAR * (m[0][0] + m[1][1] + m[2][2]));
}

/// Of a hinge, nothing about its axis; of a ball, no turn.
Inertia heldPart(Inertia w, uint freedom, vec3 axis)
{
    if (freedom == JOINT_BALL) return Inertia(regular(w.a), mat3(0), mat3(1));
    if (freedom == JOINT_HINGE) {
        mat3 along = outerProduct(axis, axis), held = mat3(1) - along;
        w.b = held * w.b;
        w.d = held * w.d * held + (w.d[0][0] + w.d[1][1] + w.d[2][2]) * along;
    }
    return Inertia(regular(w.a), w.b, regular(w.d));
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (isAsleep(fetchMover(fetchJointBodies(tree.first).body).assembly)) return;
    for (uint loop = tree.firstLoop; loop < tree.loopEnd; ++loop) {
        JointBodies joint = fetchJointBodies(loop);
        JointSide body = jointSide(loop, 0u, joint.body), parent = jointSide(loop, 1u, joint.parent);
        JointFactor f = JointFactor(Inertia(mat3(0), mat3(0), mat3(0)), mat3(0), body.arm, parent.arm,
                                    rotate(body.frame, vec3(1, 0, 0)), leftOf(startError(body, parent, joint.freedom)));
        for (int c = 0; c < (joint.freedom == JOINT_BALL ? 3 : 6); ++c) {
            Force unit = Force(vec3(0), vec3(0));
            if (c < 3) unit.t[c] = 1.0;
            else unit.r[c - 3] = 1.0;
            passLoopForce(tree, loop, f, unit);
            for (uint k = tree.first; k < tree.end; ++k) follow(k, fetchJointBodies(k));
            Motion m = loopMotion(loop, f, SLOT_MOTION);
            if (c < 3) f.inertia.a[c] = m.t;
            if (c < 3) f.inertia.b[c] = m.r;
            else f.inertia.d[c - 3] = m.r;
        }
        f.inertia = heldPart(f.inertia, joint.freedom, f.axis);
        STORE_JOINT_FACTOR(newJointFactors, loop, f)
    }
}
