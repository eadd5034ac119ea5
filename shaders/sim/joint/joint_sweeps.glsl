// Solves a tree of joints for given forces and errors: passes forces from the leaves to the root, then motions from the
// root to the leaves (Featherstone 2008, articulated bodies). A body that does not respond passes no force, and has
// done its motion of the substep before: here it is zero.
#include "sim/joint/joint_factors.glsl"
#include "sim/joint/joint_info.glsl"
#include "sim/joint/joint_sweep_records.glsl"

uniform samplerBuffer jointFactors;
uniform samplerBuffer rootFactors;

JointFactor fetchJointFactor(uint joint)
{
    int first = int(JOINT_FACTOR_TEXELS * joint);
#define TEXEL(k) texelFetch(jointFactors, first + k)
    return JOINT_FACTOR_FROM(TEXEL);
#undef TEXEL
}

/// Only the `kept` of a record.
Motion fetchJointKept(uint joint)
{
    int first = int(JOINT_FACTOR_TEXELS * joint);
#define TEXEL(k) texelFetch(jointFactors, first + k)
    return JOINT_KEPT_FROM(TEXEL);
#undef TEXEL
}

FactoredInertia fetchRootFactor(uint joint)
{
    int first = int(ROOT_FACTOR_TEXELS * joint);
#define TEXEL(k) texelFetch(rootFactors, first + k)
    return ROOT_FACTOR_FROM(TEXEL);
#undef TEXEL
}

/// The motion of a body at its joint, and the force of its joint for it.
struct Answer {
    Motion motion;
    Force held;
};

/// @param given motion that the joint gives: its parent's there, less the joint's error. @param f on the body.
Answer answerTo(JointFactor factor, uint freedom, Motion given, Force f)
{
    Inertia m = factor.inertia;
    Motion motion = given;
    motion.r += freeTurn(factor, freedom, f.r - m.b * given.t - m.d * given.r);
    Force needed = product(m, motion);
    return Answer(motion, Force(needed.t - f.t, needed.r - f.r));
}

/// Passes the force on a body, those of what hangs on it, and the one for its joint's error to its parent.
/// @param stop the torque of the joint's limits.
void passForce(uint k, Force own, Motion error, vec3 stop)
{
    Joint joint = fetchJoint(k);
    own = withHanded(k, joint, own);
    Force passed = Force(vec3(0), vec3(0));
    uint freedom = fetchFreedom(k);
    if (responds(joint.body) && freedom != JOINT_NONE) {
        JointFactor factor = fetchJointFactor(k);
        own = shifted(own, factor.arm);
        own.r += stop;
        Force held = answerTo(factor, freedom, Motion(-error.t, -error.r), own).held;
        passed = shifted(Force(-held.t, -held.r - stop), -factor.parentArm);
    }
    storeHandedForce(k, passed);
    storeAsked(k, Asked(own, error));
}

/// The force at a joint, without that of its limits, and the motion of its body, whose parent has moved already.
Answer follow(uint k)
{
    Joint joint = fetchJoint(k);
    uint freedom = fetchFreedom(k);
    Answer answer = Answer(Motion(vec3(0), vec3(0)), Force(vec3(0), vec3(0)));
    bool free = responds(joint.body);
    if (free && freedom == JOINT_NONE) answer.motion = solve(fetchRootFactor(k), loadAsked(k).force);
    if (free && freedom != JOINT_NONE) {
        JointFactor factor = fetchJointFactor(k);
        Asked asked = loadAsked(k);
        Motion given = Motion(vec3(0), vec3(0));
        if (joint.parentJoint != NONE) given = shifted(motionOfParent(k, joint), factor.parentArm);
        given = Motion(given.t - asked.error.t, given.r - asked.error.r);
        answer = answerTo(factor, freedom, given, asked.force);
        if (freedom == JOINT_BALL) answer.held.r = vec3(0);
        if (freedom == JOINT_HINGE) answer.held.r -= factor.axis * dot(factor.axis, answer.held.r);
        answer.motion = shifted(answer.motion, -factor.arm);
    }
    storeSwept(k, answer.motion);
    return answer;
}
