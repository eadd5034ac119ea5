// Length of a tree's step of Newton's method.
#include "sim/joint/joint_damping.glsl"
#include "sim/joint/joint_sweeps.glsl"

BUFFER(float, TreeTurns, treeTurns);

/// Once the parent answers, the force that was passed to it is no longer needed: the force at the joint replaces it.
void storeAnswer(uint k, Answer answer)
{
    storeHandedForce(k, answer.held);
}

Answer loadAnswer(uint k)
{
    return Answer(loadMotion(k, SWEEP_MOTION), loadHandedForce(k));
}

/// Stores the answers of all bodies of a tree, and how far it turns. @returns the part of them that it takes, so that
/// no body that carries far more than itself turns too far.
float partToTake(uint index, JointTree tree)
{
    const float MOST_LOADED_TURN = 0.08;   // [rad]
    float turn = 0.0, loaded = 1e-12;
    for (uint k = tree.first; k < tree.end; ++k) {
        Answer answer = follow(k);
        storeAnswer(k, answer);
        float squared = dot(answer.motion.r, answer.motion.r);
        turn = max(turn, squared);
        bool carries = fetchFreedom(k) != JOINT_NONE && loadOn(k, fetchJointFactor(k).inertia.a) > 0.0;
        if (carries) loaded = max(loaded, squared);
    }
    treeTurns[index] = turn;
    return min(1.0, MOST_LOADED_TURN * inversesqrt(loaded));
}
