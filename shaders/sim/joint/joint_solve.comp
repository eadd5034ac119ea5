// One thread a tree of joints: the impulses with which all its joints hold, at once, and where they bring its bodies: a
// Newton step of their positions (Deul et al. 2018). LOOPS: of a world where joints close loops. LIMITS: where joints
// are limited.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/body_loads.glsl"
#include "sim/joint/joint_pose.glsl"
#ifdef LIMITS
#include "sim/joint/joint_stop_solve.glsl"
#endif
#include "sim/joint/joint_sweeps.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
BUFFER(vec4, MoverMoves, newMoverMoves);
BUFFER(vec4, MoverRotationDeltas, newMoverRotationDeltas);
uniform samplerBuffer lastRowImpulses;
BUFFER(vec4, RowImpulses, newRowImpulses);
#ifdef ANGULAR
uniform samplerBuffer lastRowAngularImpulses;
BUFFER(vec4, RowAngularImpulses, newRowAngularImpulses);
#endif

/// A joint's error, but for what this substep leaves of it.
Motion jointError(uint k, TreeJoint joint)
{
    Motion left = Motion(texelFetch(jointFactors, int(JOINT_FACTOR * k + 9u)).xyz,
                         texelFetch(jointFactors, int(JOINT_FACTOR * k + 10u)).xyz);
    Motion error = errorNow(jointSide(k, 0u, joint.body), jointSide(k, 1u, joint.parent), joint.freedom);
    return Motion(error.t - left.t, error.r - left.r);
}

// Where each row is pushed once, what was there comes by a texture, which llvmpipe reads three times as fast.
#if defined(LOOPS) || defined(LIMITS)
#define ROW(name, row) new##name[row].xyz
#else
#define ROW(name, row) texelFetch(last##name, int(row)).xyz
#endif

void push(uint row, Force f)
{
    if (row == NONE) return;
    newRowImpulses[row] = vec4(ROW(RowImpulses, row) + f.t, 0);
#ifdef ANGULAR
    newRowAngularImpulses[row].xyz = ROW(RowAngularImpulses, row) + f.r;
#endif
}

void pushBoth(uint k, Force held)
{
    JointRows rows = fetchJointRows(k);
    push(rows.row, held);
    push(rows.parentRow, Force(-held.t, -held.r));
}

void moveBody(uint body, Motion m)
{
    newMoverMoves[body].xyz = fetchMove(body).shift + m.t;
    vec4 turned = quaternionProduct(quaternionFromSmallRotation(m.r), fetchRotationDelta(body));
    newMoverRotationDeltas[body] = normalize(turned);
}

#ifdef LOOPS
#include "sim/joint/joint_loops.glsl"

void closeLoop(JointTree tree, uint loop)
{
    TreeJoint joint = fetchTreeJoint(loop);
    if (joint.freedom == JOINT_NONE) return;
    JointFactor factor = fetchJointFactor(loop);
    Motion error = jointError(loop, joint), moves = loopMotion(loop, factor, SLOT_TOTAL);
    LoopGive give = loadGive(factor);
    uint row = fetchJointRows(loop).row;
    error = Motion(error.t + moves.t + give.move * newRowImpulses[row].xyz, error.r + moves.r);
#ifdef ANGULAR
    error.r += give.turn * newRowAngularImpulses[row].xyz;
#endif
    if (joint.freedom == JOINT_BALL) error.r = vec3(0);
    if (joint.freedom == JOINT_HINGE) error.r -= factor.axis * dot(factor.axis, error.r);
    Motion pull = solve(factor.inertia, Force(-error.t, -error.r));
    pushBoth(loop, Force(pull.t, pull.r));
    passLoopForce(tree, loop, factor, Force(pull.t, pull.r));
    for (uint k = tree.first; k < tree.end; ++k) {
        Answer answer = follow(k, fetchTreeJoint(k));
        pushBoth(k, answer.held);
        addMotion(k, SLOT_TOTAL, answer.motion);
    }
}
#endif

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (isAsleep(fetchMover(fetchTreeJoint(tree.first).body).assembly)) return;
    for (uint k = tree.end; k-- > tree.first;) {
        TreeJoint joint = fetchTreeJoint(k);
        BodyLoad load = fetchBodyLoad(joint.body);
        Motion error = Motion(vec3(0), vec3(0));
        vec3 stop = vec3(0);
        if (joint.freedom != JOINT_NONE) {
            error = jointError(k, joint);
#ifdef LIMITS
            stop = stopTorque(k);
            if (stop != vec3(0)) pushBoth(k, Force(vec3(0), stop));
#endif
        }
        passForce(k, Force(load.force, load.torque), error, stop);
    }
    for (uint k = tree.first; k < tree.end; ++k) {
        TreeJoint joint = fetchTreeJoint(k);
        Answer answer = follow(k, joint);
        pushBoth(k, answer.held);
#ifdef LOOPS
        storeMotion(k, SLOT_TOTAL, answer.motion);
#else
        moveBody(joint.body, answer.motion);
#endif
    }
#ifdef LOOPS
    for (uint loop = tree.firstLoop; loop < tree.loopEnd; ++loop) closeLoop(tree, loop);
    for (uint k = tree.first; k < tree.end; ++k) moveBody(fetchTreeJoint(k).body, loadMotion(k, SLOT_TOTAL));
#endif
}
