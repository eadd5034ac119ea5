// Forces of several loops of a tree at once, by conjugate gradients: how far each loop gives by itself is the
// preconditioner, and each round goes through the tree once.
#include "sim/joint/loops/loop_searches.glsl"

/// How the tree answers to these forces, in SWEEP_MOTION.
void answerLoopForces(JointTree tree, uint part)
{
    passLoopForces(tree, part);
    for (uint k = tree.first; k < tree.end; ++k) follow(k);
}

/// Of a motion of a loop's ends, what the loop holds.
Motion heldOf(uint loop, LoopFactor factor, Motion m)
{
    uint freedom = fetchFreedom(loop);
    if (freedom == JOINT_BALL) m.r = vec3(0);
    if (freedom == JOINT_HINGE) m.r -= factor.axis * dot(factor.axis, m.r);
    return m;
}

/// How far the ends move by the forces that were passed, and by what the loop gives to `f`.
Motion movedBy(uint loop, LoopFactor factor, Force f)
{
    Motion m = heldOf(loop, factor, loopMotion(loop, factor.arm, factor.parentArm, SWEEP_MOTION));
    return Motion(m.t + factor.givenMove * f.t, m.r + factor.givenTurn * f.r);
}

/// Notes by which force a loop would be right if it were alone. @returns its product with what it is wrong by.
float noteAlone(uint loop, LoopFactor factor, Motion wrong)
{
    Motion force = solve(factored(factor.apart), Force(-wrong.t, -wrong.r));
    storeSearch(loop, SEARCH_MOVED, force.t, force.r);
    return -dot(force.t, wrong.t) - dot(force.r, wrong.r);
}

/// Adds what stray torques move, and begins with the forces by which each loop alone would be right.
/// @returns the sum of noteAlone().
float beginSearch(JointTree tree)
{
#ifdef ANGULAR
    answerLoopForces(tree, SEARCH_FORCE);
#endif
    float left = 0.0;
    FOR_ACTING_LOOPS(tree, loop) {
        LoopFactor factor = fetchLoopFactor(loop);
        Force was = loadSearch(loop, SEARCH_WRONG);
        Motion wrong = Motion(was.t, was.r);
#ifdef ANGULAR
        Motion stray = heldOf(loop, factor, loopMotion(loop, factor.arm, factor.parentArm, SWEEP_MOTION));
        wrong = Motion(wrong.t + stray.t, wrong.r + stray.r);
        storeSearch(loop, SEARCH_WRONG, wrong.t, wrong.r);
#endif
        left += noteAlone(loop, factor, wrong);
        Force alone = loadSearch(loop, SEARCH_MOVED);
        storeSearch(loop, SEARCH_ALONG, alone.t, alone.r);
    }
    return left;
}

/// One round. @param left sum of noteAlone(), which it changes. @returns what the worst loop is wrong by then.
float searchRound(JointTree tree, inout float left)
{
    answerLoopForces(tree, SEARCH_ALONG);
    float work = 0.0, now = 0.0, wrong = 0.0;
    FOR_ACTING_LOOPS(tree, loop) {
        Force along = loadSearch(loop, SEARCH_ALONG);
        Motion moved = movedBy(loop, fetchLoopFactor(loop), along);
        storeSearch(loop, SEARCH_MOVED, moved.t, moved.r);
        work += dot(along.t, moved.t) + dot(along.r, moved.r);
    }
    float part = work > 0.0 ? left / work : 0.0;
    FOR_ACTING_LOOPS(tree, loop) {
        Force along = loadSearch(loop, SEARCH_ALONG), force = loadSearch(loop, SEARCH_FORCE);
        Force moved = loadSearch(loop, SEARCH_MOVED), was = loadSearch(loop, SEARCH_WRONG);
        Motion is = Motion(was.t + part * moved.t, was.r + part * moved.r);
        storeSearch(loop, SEARCH_FORCE, force.t + part * along.t, force.r + part * along.r);
        storeSearch(loop, SEARCH_WRONG, is.t, is.r);
        wrong = max(wrong, length(is.t) / sim.diameter + length(is.r));
        now += noteAlone(loop, fetchLoopFactor(loop), is);
    }
    FOR_ACTING_LOOPS(tree, loop) {
        Force alone = loadSearch(loop, SEARCH_MOVED), along = loadSearch(loop, SEARCH_ALONG);
        float kept = left > 0.0 ? now / left : 0.0;
        storeSearch(loop, SEARCH_ALONG, alone.t + kept * along.t, alone.r + kept * along.r);
    }
    left = now;
    return part == 0.0 ? 0.0 : wrong;
}
