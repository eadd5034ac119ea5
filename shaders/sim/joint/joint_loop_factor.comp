// One thread a tree of joints: of its joints that close loops, how far their ends move apart for each force between them
// that they can have. After joint_factor, once a substep.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/joint/joint_pose.glsl"
#include "sim/joint/joint_sweeps.glsl"
#include "sim/joint/joint_loops.glsl"
#include "sim/joint/joint_left.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
BUFFER(vec4, JointFactors, newJointFactors);

/// How far a loop gives, which keeps it regular where the tree holds it already: as a share of how far its ends move for
/// a force, and of how far its body alone would.
LoopGive giveOf(Inertia w, uint body)
{
    const float REGULAR = 1e-4;
    InverseInertia alone = fetchInverseInertia(body);
    return LoopGive(REGULAR * (traceOf(w.a) + alone.inverseMass),
                    REGULAR * (traceOf(w.d) + alone.diagonal.x + alone.diagonal.y + alone.diagonal.z));
}

/// Of a hinge, nothing about its axis; of a ball, no turn.
Inertia heldPart(Inertia w, LoopGive give, uint freedom, vec3 axis)
{
    w.a += mat3(give.move);
    if (freedom == JOINT_BALL) return Inertia(w.a, mat3(0), mat3(1));
    w.d += mat3(give.turn);
    if (freedom == JOINT_HINGE) {
        mat3 along = outerProduct(axis, axis), held = mat3(1) - along;
        w.b = held * w.b;
        w.d = held * w.d * held + traceOf(w.d) * along;
    }
    return w;
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (isAsleep(fetchMover(fetchTreeJoint(tree.first).body).assembly)) return;
    for (uint loop = tree.firstLoop; loop < tree.loopEnd; ++loop) {
        TreeJoint joint = fetchTreeJoint(loop);
        if (joint.freedom == JOINT_NONE) continue;
        JointSide body = jointSide(loop, 0u, joint.body), parent = jointSide(loop, 1u, joint.parent);
        JointFactor f = JointFactor(Inertia(mat3(0), mat3(0), mat3(0)), mat3(0), body.arm, parent.arm,
                                    rotate(body.frame, vec3(1, 0, 0)), leftOf(startError(body, parent, joint.freedom)));
        for (int c = 0; c < (joint.freedom == JOINT_BALL ? 3 : 6); ++c) {
            Force unit = Force(vec3(0), vec3(0));
            if (c < 3) unit.t[c] = 1.0;
            else unit.r[c - 3] = 1.0;
            passLoopForce(tree, loop, f, unit);
            for (uint k = tree.first; k < tree.end; ++k) follow(k, fetchTreeJoint(k));
            Motion m = loopMotion(loop, f, SLOT_MOTION);
            if (c < 3) f.inertia.a[c] = m.t;
            if (c < 3) f.inertia.b[c] = m.r;
            else f.inertia.d[c - 3] = m.r;
        }
        LoopGive give = giveOf(f.inertia, joint.body);
        f.inertia = heldPart(f.inertia, give, joint.freedom, f.axis);
        storeGive(f, give);
        STORE_JOINT_FACTOR(newJointFactors, loop, f)
    }
}
