// A tree of joints solved for given forces and errors: from the leaves to the root what each body asks of its parent,
// then motions from the root to the leaves (Featherstone 2008, articulated bodies).
#include "sim/joint/joint_factors.glsl"
#include "sim/joint/joint_info.glsl"
#include "sim/joint/joint_states.glsl"

uniform samplerBuffer jointFactors;

JointFactor fetchJointFactor(uint joint)
{
    int first = int(JOINT_FACTOR * joint);
#define TEXEL(k) texelFetch(jointFactors, first + k)
    return JOINT_FACTOR_FROM(TEXEL);
#undef TEXEL
}

/// How a body moves at its joint, and the force that its joint needs for it.
struct Answer {
    Motion motion;
    Force held;
};

/// @param given what the joint gives: the parent's motion there, less the joint's error. @param f on the body.
Answer answerTo(JointFactor factor, Motion given, Force f)
{
    Inertia m = factor.inertia;
    Motion motion = given;
    motion.r += factor.free * (f.r - m.b * given.t - m.d * given.r);
    Force needed = product(m, motion);
    return Answer(motion, Force(needed.t - f.t, needed.r - f.r));
}

/// Hands the force on a body, what hangs on it asks for, and what its joint's error asks for, to its parent.
/// @param stop the torque of the joint's limits.
void passForce(uint k, Force own, Motion error, vec3 stop)
{
    TreeJoint joint = fetchTreeJoint(k);
    JointRows rows = fetchJointRows(k);
    for (uint child = rows.firstChild; child < rows.childEnd; ++child) own = add(own, loadForce(child, SLOT_PASSED));
    if (joint.freedom != JOINT_NONE) {
        JointFactor factor = fetchJointFactor(k);
        own = shifted(own, factor.arm);
        own.r += stop;
        Force held = answerTo(factor, Motion(-error.t, -error.r), own).held;
        storeForce(k, SLOT_PASSED, shifted(Force(-held.t, -held.r - stop), -factor.parentArm));
    }
    storeAsked(k, Asked(own, error));
}

/// The force at a joint and the motion of its body, whose parent has moved already.
Answer follow(uint k, TreeJoint joint)
{
    JointFactor factor = fetchJointFactor(k);
    Asked asked = loadAsked(k);
    Answer answer = Answer(Motion(vec3(0), vec3(0)), Force(vec3(0), vec3(0)));
    if (joint.freedom == JOINT_NONE) {
        answer.motion = product(Response(factor.inertia.a, factor.inertia.b, factor.inertia.d), asked.force);
    } else {
        Motion given = Motion(vec3(0), vec3(0));
        if (joint.parentJoint != NONE) given = shifted(loadMotion(joint.parentJoint, SLOT_MOTION), factor.parentArm);
        given = Motion(given.t - asked.error.t, given.r - asked.error.r);
        answer = answerTo(factor, given, asked.force);
        vec3 yielded = vec3(0);
#ifdef LIMITS
        yielded = stopYield(k, answer.motion.r - given.r);
#endif
        if (joint.freedom == JOINT_BALL) answer.held.r = yielded;
        if (joint.freedom == JOINT_HINGE) answer.held.r += factor.axis * dot(factor.axis, yielded - answer.held.r);
        answer.motion = shifted(answer.motion, -factor.arm);
    }
    storeMotion(k, SLOT_MOTION, answer.motion);
    return answer;
}
