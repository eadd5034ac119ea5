// One thread a tree of joints: for each of its loops, how far the ends move apart for each force that they can have
// between them. After joint_factor, once a substep.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/joint/joint_pose.glsl"
#include "sim/joint/joint_rows.glsl"
#include "sim/joint/loops/joint_loops.glsl"
#include "sim/joint/joint_recovery.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
BUFFER(vec4, LoopFactors, newLoopFactors);

/// How far a loop gives, as a share of how far its ends, and its body alone, would move for a force.
vec2 giveOf(Inertia w, uint body)
{
    const float REGULAR = 1e-4;
    InverseInertia alone = fetchInverseInertia(body);
    return vec2(REGULAR * (traceOf(w.a) + alone.inverseMass),
                REGULAR * (traceOf(w.d) + alone.diagonal.x + alone.diagonal.y + alone.diagonal.z));
}

/// The part that a joint holds: a hinge holds nothing about its axis, a ball no turn.
Inertia heldPart(Inertia w, vec2 give, uint freedom, vec3 axis)
{
    w.a += mat3(give.x);
    if (freedom == JOINT_BALL) return Inertia(w.a, mat3(0), mat3(1));
    w.d += mat3(give.y);
    if (freedom == JOINT_HINGE) {
        mat3 along = outerProduct(axis, axis), held = mat3(1) - along;
        w.b = held * w.b;
        w.d = held * w.d * held + traceOf(w.d) * along;
    }
    return w;
}

/// How far each unit force between the ends moves them apart.
Inertia triedApart(JointTree tree, uint loop, uint freedom, vec3 arm, vec3 parentArm)
{
    Inertia w = Inertia(mat3(0), mat3(0), mat3(0));
    for (int c = 0; c < (freedom == JOINT_BALL ? 3 : 6); ++c) {
        Force unit = Force(vec3(0), vec3(0));
        if (c < 3) unit.t[c] = 1.0;
        else unit.r[c - 3] = 1.0;
        passLoopForce(tree, loop, arm, parentArm, unit);
        for (uint k = tree.first; k < tree.end; ++k) follow(k);
        Motion m = loopMotion(loop, arm, parentArm, SWEEP_MOTION);
        if (c < 3) w.a[c] = m.t;
        if (c < 3) w.b[c] = m.r;
        else w.d[c - 3] = m.r;
    }
    return w;
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (treeRests(tree)) return;
    uvec2 range = loopsOfPass(index, tree);
    for (uint loop = range.x; loop < range.y; ++loop) {
        Joint joint = fetchJoint(loop);
        if (!loopActs(loop)) {
            if (standsIn(joint)) clearRows(joint);
            continue;
        }
        uint freedom = fetchFreedom(loop);
        JointSide body = jointSide(loop, 0u, joint.body), parent = jointSide(loop, 1u, joint.parent);
        vec3 axis = rotate(body.frame, vec3(1, 0, 0));
        Inertia w = triedApart(tree, loop, freedom, body.arm, parent.arm);
        vec2 give = giveOf(w, joint.body);
        LoopFactor f = LoopFactor(heldPart(w, give, freedom, axis), body.arm, parent.arm, axis,
                                  keptOf(startError(body, parent, freedom)), give.x, give.y);
        STORE_LOOP_FACTOR(newLoopFactors, loop, f)
    }
}
