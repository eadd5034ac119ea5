// What the sweeps over a tree leave for each other: JOINT_STATE vec4s a joint.
#include "math/spatial.glsl"

BUFFER(vec4, JointStates, jointStates);

#define JOINT_STATE 8u
/// What a body asks of its parent; the force on it; its joint's error, then its motion; with loops, all its motions.
#define SLOT_PASSED 0u
#define SLOT_FORCE 2u
#define SLOT_MOTION 4u
#define SLOT_TOTAL 6u

Force loadForce(uint joint, uint slot)
{
    uint first = JOINT_STATE * joint + slot;
    return Force(jointStates[first].xyz, jointStates[first + 1u].xyz);
}

void storeForce(uint joint, uint slot, Force f)
{
    uint first = JOINT_STATE * joint + slot;
    jointStates[first].xyz = f.t;
    jointStates[first + 1u].xyz = f.r;
}

Motion loadMotion(uint joint, uint slot)
{
    uint first = JOINT_STATE * joint + slot;
    return Motion(jointStates[first].xyz, jointStates[first + 1u].xyz);
}

void storeMotion(uint joint, uint slot, Motion m)
{
    uint first = JOINT_STATE * joint + slot;
    jointStates[first].xyz = m.t;
    jointStates[first + 1u].xyz = m.r;
}

void addMotion(uint joint, uint slot, Motion m)
{
    uint first = JOINT_STATE * joint + slot;
    jointStates[first].xyz += m.t;
    jointStates[first + 1u].xyz += m.r;
}
