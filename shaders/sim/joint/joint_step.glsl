// How far a tree goes in one step of Newton's method.
#include "sim/joint/joint_damping.glsl"
#include "sim/joint/joint_sweeps.glsl"

BUFFER(float, TreeTurns, treeTurns);

/// A tree takes of its answer no more than what turns bodies that carry far more than themselves by this [rad].
const float MOST_TURN = 0.08;

/// @returns the part of its answer that a tree takes.
float answered(uint index, JointTree tree)
{
    float turn = 0.0, loaded = 1e-12;
    for (uint k = tree.first; k < tree.end; ++k) {
        Answer answer = follow(k);
        storePassedForce(k, answer.held);
        float squared = dot(answer.motion.r, answer.motion.r);
        turn = max(turn, squared);
        bool carries = fetchFreedom(k) != JOINT_NONE && loadOn(k, fetchJointFactor(k).inertia.a) > 0.0;
        if (carries && responds(fetchJoint(k).body)) loaded = max(loaded, squared);
    }
    treeTurns[index] = turn;
    return min(1.0, MOST_TURN * inversesqrt(loaded));
}
