// One thread a tree of joints, after joint_solve: forces between the ends of its loops, which the whole tree answers,
// correct their errors; then the bodies move.
#define MANY_PUSHES
#include "sim/common/kernel.glsl"
#include "sim/joint/joint_error.glsl"
#include "sim/joint/joint_rows.glsl"
#include "sim/joint/joint_sweeps.glsl"
#ifdef LIMITS
#include "sim/joint/limits/joint_limit_solve.glsl"
#endif
#include "sim/joint/loops/loop_search.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;

/// What a loop is wrong by, of what it holds.
Motion errorOf(uint loop, LoopFactor factor)
{
    uint row = fetchJoint(loop).row;
    Motion error = errorBeyond(loop, factor.kept);
    Motion moves = loopMotion(loop, factor.arm, factor.parentArm, SWEEP_TOTAL);
    error = Motion(error.t + moves.t + factor.givenMove * newRowImpulses[row].xyz, error.r + moves.r);
#ifdef ANGULAR
    error.r += factor.givenTurn * newRowAngularImpulses[row].xyz;
#endif
    return heldOf(loop, factor, error);
}

/// The part of a hinge's remembered torque about the turned hinge would drive the hinge: the torque that cancels it.
vec3 strayTorque(uint loop, LoopFactor factor)
{
#ifdef ANGULAR
    if (fetchFreedom(loop) == JOINT_HINGE)
        return -(factor.axis * dot(factor.axis, newRowAngularImpulses[fetchJoint(loop).row].xyz));
#endif
    return vec3(0);
}

/// The tree takes its answer to the forces that were passed.
void take(JointTree tree)
{
    for (uint k = tree.first; k < tree.end; ++k) {
        Answer answer = follow(k);
#ifdef LIMITS
        answer.held.r += limitTorqueOf(k, answer, 1.0);
#endif
        pushBoth(k, answer.held);
        addMotion(k, SWEEP_TOTAL, answer.motion);
    }
}

void closeOne(JointTree tree, uint loop)
{
    if (!loopActs(loop)) return;
    LoopFactor factor = fetchLoopFactor(loop);
    Motion error = errorOf(loop, factor);
    Motion pull = solve(factored(factor.apart), Force(-error.t, -error.r));
    pull.r += strayTorque(loop, factor);
    pushBoth(loop, Force(pull.t, pull.r));
    passLoopForce(tree, loop, factor.arm, factor.parentArm, Force(pull.t, pull.r));
    take(tree);
}

/// @returns what the worst loop is wrong by in the end [rad and diameters].
float closeAll(JointTree tree)
{
    FOR_ACTING_LOOPS(tree, loop) {
        LoopFactor factor = fetchLoopFactor(loop);
        Motion error = errorOf(loop, factor);
        storeSearch(loop, SEARCH_WRONG, error.t, error.r);
        storeSearch(loop, SEARCH_FORCE, vec3(0), strayTorque(loop, factor));
    }
    float left = beginSearch(tree), wrong = 1.0;
    for (uint round = 0u; round < LOOP_ROUNDS && wrong > LOOP_ERROR; ++round) wrong = searchRound(tree, left);
    passLoopForces(tree, SEARCH_FORCE);
    FOR_ACTING_LOOPS(tree, loop) pushBoth(loop, loadSearch(loop, SEARCH_FORCE));
    take(tree);
    return wrong;
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (treeRests(tree)) return;
    LoopSeries series = beginSeries(index);
    uint count = tree.loopEnd - tree.firstLoop;
    float wrong = 0.0;
    if (!series.hold && count == 1u) closeOne(tree, tree.firstLoop);
    if (!series.hold && count > 1u) wrong = closeAll(tree);
    endSeries(index, series, wrong);
    if (!series.last) return;
    for (uint k = tree.first; k < tree.end; ++k) moveBody(fetchJoint(k).body, loadMotion(k, SWEEP_TOTAL));
}
