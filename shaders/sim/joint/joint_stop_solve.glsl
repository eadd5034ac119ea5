// What stops do while the joints of a tree are solved.
#include "sim/joint/joint_stops.glsl"

/// The torque that a joint's stops add before anything moves: what they would hold where the body is now, less what
/// they held.
vec3 stopTorque(uint k)
{
    JointLimit limit = fetchJointLimit(k);
    if (!isLimited(limit)) return vec3(0);
    TreeJoint joint = fetchTreeJoint(k);
    Beyond b = beyondLimits(limit, jointSide(k, 1u, joint.parent).frame, jointSide(k, 0u, joint.body).frame);
    float beyond[2] = float[2](b.swing, b.turn);
    JointStop s = loadStop(k);
    for (int i = 0; i < 2; ++i) {
        if (limit.stiffness > 0.0) s.held[i] = 0.0;
        s.held[i] += s.hardness[i] * (beyond[i] - s.left[i]);
        if (s.hardness[i] == 0.0) s.held[i] = 0.0;
    }
    storeStop(k, s);
    vec3 before = jointStops[JOINT_STOP * k + STOP_TORQUE].xyz, torque = torqueOf(s);
    jointStops[JOINT_STOP * k + STOP_TORQUE].xyz = torque;
    return torque - before;
}

/// The torque that they add as the joint turns by as much.
vec3 stopYield(uint k, vec3 turn)
{
    if (!isLimited(fetchJointLimit(k))) return vec3(0);
    JointStop s = loadStop(k);
    for (int i = 0; i < 2; ++i) s.held[i] += s.hardness[i] * dot(s.axes[i], turn);
    storeStop(k, s);
    vec3 before = jointStops[JOINT_STOP * k + STOP_TORQUE].xyz, torque = torqueOf(s);
    jointStops[JOINT_STOP * k + STOP_TORQUE].xyz = torque;
    return torque - before;
}
