// The stops' part in solving the joints of a tree.
#include "sim/joint/limits/joint_limit_states.glsl"
#include "sim/joint/joint_sweeps.glsl"

void storeHeld(uint joint, JointLimitState s)
{
    newJointLimitStates[JOINT_LIMIT_TEXELS * joint + LIMIT_HELD].xy = vec2(s.held[0], s.held[1]);
}

/// The state of a stop, with what this dispatch has stored.
JointLimitState loadLimitState(uint joint)
{
    JointLimitState s = fetchLimitState(joint);
    vec2 held = newJointLimitStates[JOINT_LIMIT_TEXELS * joint + LIMIT_HELD].xy;
    s.held = float[2](held.x, held.y);
    return s;
}

/// The torque that a joint's stops have added to its rows before this dispatch.
vec3 oldLimitTorque(uint joint)
{
    return texelFetch(lastJointLimitStates, int(JOINT_LIMIT_TEXELS * joint + LIMIT_TORQUE)).xyz;
}

/// The torque that a joint's stops add before anything moves: what they would hold where the body is now, less what
/// they held. limitTorqueOf() adds it to the rows, together with what motion adds.
vec3 limitTorque(uint k)
{
    JointRange limits = fetchJointLimits(k);
    if (!isLimited(limits)) return vec3(0);
    Joint joint = fetchJoint(k);
    Excess e = excessOver(limits, jointSide(k, 1u, joint.parent).frame, jointSide(k, 0u, joint.body).frame);
    float excess[2] = float[2](e.swing, e.turn);
    JointLimitState s = fetchLimitState(k);
    for (int i = 0; i < 2; ++i) {
        if (limits.stiffness > 0.0) s.held[i] = 0.0;
        s.held[i] += s.hardness[i] * (excess[i] - s.kept[i]);
        if (s.hardness[i] == 0.0) s.held[i] = 0.0;
    }
    storeHeld(k, s);
    return torqueOf(s) - oldLimitTorque(k);
}

/// The torque that stops add to the joint's rows: that of limitTorque(), and that for the joint's turn by a part of
/// what this sweep has given to its bodies.
vec3 limitTorqueOf(uint k, Answer answer, float part)
{
    if (!isLimited(fetchJointLimits(k))) return vec3(0);
    uint parent = fetchJoint(k).parentJoint, freedom = fetchFreedom(k), torque = JOINT_LIMIT_TEXELS * k + LIMIT_TORQUE;
    vec3 turn = answer.motion.r;
    if (parent != NONE) turn -= loadMotion(parent, SWEEP_MOTION).r;
    JointLimitState s = loadLimitState(k);
    vec3 before = torqueOf(s);
    for (int i = 0; i < 2; ++i) s.held[i] += s.hardness[i] * part * dot(s.axes[i], turn);
    storeHeld(k, s);
    vec3 now = torqueOf(s), change = now - before, asked = before - newJointLimitStates[torque].xyz;
    newJointLimitStates[torque].xyz = now;
    if (freedom == JOINT_BALL) return asked + change;
    vec3 axis = fetchJointFactor(k).axis;
    return asked + (freedom == JOINT_HINGE ? axis * dot(axis, change) : vec3(0));
}
