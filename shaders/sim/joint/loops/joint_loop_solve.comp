// One thread a tree of joints, after joint_solve: each of its loops in turn corrects its error by a force between its
// ends, to which the whole tree answers; then the bodies move.
#define MANY_PUSHES
#include "sim/common/kernel.glsl"
#include "sim/joint/joint_error.glsl"
#include "sim/joint/joint_rows.glsl"
#include "sim/joint/joint_sweeps.glsl"
#ifdef LIMITS
#include "sim/joint/limits/joint_limit_solve.glsl"
#endif
#include "sim/joint/loops/joint_loops.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
uniform samplerBuffer loopFactors;

LoopFactor fetchLoopFactor(uint loop)
{
    int first = int(loopEntry(loop));
#define TEXEL(k) texelFetch(loopFactors, first + k)
    return LOOP_FACTOR_FROM(TEXEL);
#undef TEXEL
}

void closeLoop(JointTree tree, uint loop)
{
    if (!loopActs(loop)) return;
    uint freedom = fetchFreedom(loop), row = fetchJoint(loop).row;
    LoopFactor factor = fetchLoopFactor(loop);
    Motion error = errorBeyond(loop, factor.kept);
    Motion moves = loopMotion(loop, factor.arm, factor.parentArm, SWEEP_TOTAL);
    error = Motion(error.t + moves.t + factor.givenMove * newRowImpulses[row].xyz, error.r + moves.r);
#ifdef ANGULAR
    error.r += factor.givenTurn * newRowAngularImpulses[row].xyz;
#endif
    if (freedom == JOINT_BALL) error.r = vec3(0);
    if (freedom == JOINT_HINGE) error.r -= factor.axis * dot(factor.axis, error.r);
    Motion pull = solve(factored(factor.apart), Force(-error.t, -error.r));
#ifdef ANGULAR
    // The part of its remembered torque about the turned hinge would drive the hinge.
    if (freedom == JOINT_HINGE) pull.r -= factor.axis * dot(factor.axis, newRowAngularImpulses[row].xyz);
#endif
    pushBoth(loop, Force(pull.t, pull.r));
    passLoopForce(tree, loop, factor.arm, factor.parentArm, Force(pull.t, pull.r));
    for (uint k = tree.first; k < tree.end; ++k) {
        Answer answer = follow(k);
#ifdef LIMITS
        answer.held.r += limitTorqueOf(k, answer, 1.0);
#endif
        pushBoth(k, answer.held);
        addMotion(k, SWEEP_TOTAL, answer.motion);
    }
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (treeRests(tree)) return;
    for (uint loop = tree.firstLoop; loop < tree.loopEnd; ++loop) closeLoop(tree, loop);
    for (uint k = tree.first; k < tree.end; ++k) moveBody(fetchJoint(k).body, loadMotion(k, SWEEP_TOTAL));
}
