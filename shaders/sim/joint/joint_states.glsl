// What the sweeps over a tree leave for each other: JOINT_STATE vec4s a joint.
#include "math/spatial.glsl"

BUFFER(vec4, JointStates, jointStates);

#define JOINT_STATE 9u
/// What a body asks of its parent; what it is asked itself; its motion; with loops, all its motions.
#define SLOT_PASSED 0u
#define SLOT_ASKED 2u
#define SLOT_MOTION 5u
#define SLOT_TOTAL 7u

struct Asked {
    Force force;    // on the body with all that hangs on it, at its joint
    Motion error;   // of its joint
};

void storeAsked(uint joint, Asked asked)
{
    uint first = JOINT_STATE * joint + SLOT_ASKED;
    jointStates[first] = vec4(asked.force.t, asked.error.t.x);
    jointStates[first + 1u] = vec4(asked.force.r, asked.error.t.y);
    jointStates[first + 2u] = vec4(asked.error.r, asked.error.t.z);
}

Asked loadAsked(uint joint)
{
    uint first = JOINT_STATE * joint + SLOT_ASKED;
    vec4 a = jointStates[first], b = jointStates[first + 1u], c = jointStates[first + 2u];
    return Asked(Force(a.xyz, b.xyz), Motion(vec3(a.w, b.w, c.w), c.xyz));
}

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
