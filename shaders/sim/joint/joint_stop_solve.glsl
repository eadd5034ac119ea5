// What stops do while the joints of a tree are solved.
#include "sim/joint/joint_stops.glsl"
#include "sim/joint/joint_sweeps.glsl"

/// Stores what a joint's stops hold. @returns how their torque changes by it.
vec3 torqueChange(uint k, JointStop s)
{
    storeStop(k, s);
    vec3 before = jointStops[JOINT_STOP_TEXELS * k + STOP_TORQUE].xyz, torque = torqueOf(s);
    jointStops[JOINT_STOP_TEXELS * k + STOP_TORQUE].xyz = torque;
    return torque - before;
}

/// The torque that a joint's stops add before anything moves: what they would hold where the body is now, less what
/// they held.
vec3 stopTorque(uint k)
{
    JointLimits limits = fetchJointLimits(k);
    if (!isLimited(limits)) return vec3(0);
    JointInfo joint = fetchJoint(k);
    Excess e = excessOver(limits, jointSide(k, 1u, joint.parent).frame, jointSide(k, 0u, joint.body).frame);
    float excess[2] = float[2](e.swing, e.turn);
    JointStop s = loadStop(k);
    for (int i = 0; i < 2; ++i) {
        if (limits.stiffness > 0.0) s.held[i] = 0.0;
        s.held[i] += s.hardness[i] * (excess[i] - s.kept[i]);
        if (s.hardness[i] == 0.0) s.held[i] = 0.0;
    }
    return torqueChange(k, s);
}

/// The torque that they add as the joint turns by a part of what this sweep has given to its bodies.
vec3 stopTorqueOf(uint k, float part)
{
    if (!isLimited(fetchJointLimits(k))) return vec3(0);
    uint parent = fetchJoint(k).parentJoint, freedom = fetchFreedom(k);
    vec3 turn = loadMotion(k, SWEEP_MOTION).r;
    if (parent != NONE) turn -= loadMotion(parent, SWEEP_MOTION).r;
    JointStop s = loadStop(k);
    for (int i = 0; i < 2; ++i) s.held[i] += s.hardness[i] * part * dot(s.axes[i], turn);
    vec3 change = torqueChange(k, s);
    if (freedom == JOINT_BALL) return change;
    vec3 axis = fetchJointFactor(k).axis;
    return freedom == JOINT_HINGE ? axis * dot(axis, change) : vec3(0);
}
