// What the sweeps over a tree leave for each other, of each joint: what its body asks of its parent, what the body is
// asked itself, how it moves in this sweep, and, where joints close loops, in all sweeps of a solve.
#include "math/spatial.glsl"
#include "shared/joint_records.h"

BUFFER(vec4, JointSweeps, jointSweeps);

#define SWEEP_PASSED 0u
#define SWEEP_ASKED 2u
#define SWEEP_MOTION 5u
#define SWEEP_TOTAL 7u

uint sweepEntry(uint joint, uint part)
{
    return JOINT_SWEEP_TEXELS * joint + part;
}

struct Asked {
    Force force;    // on the body with all that hangs on it, at its joint
    Motion error;   // of its joint
};

void storeAsked(uint joint, Asked asked)
{
    uint first = sweepEntry(joint, SWEEP_ASKED);
    jointSweeps[first] = vec4(asked.force.t, asked.error.t.x);
    jointSweeps[first + 1u] = vec4(asked.force.r, asked.error.t.y);
    jointSweeps[first + 2u] = vec4(asked.error.r, asked.error.t.z);
}

Asked loadAsked(uint joint)
{
    uint first = sweepEntry(joint, SWEEP_ASKED);
    vec4 a = jointSweeps[first], b = jointSweeps[first + 1u], c = jointSweeps[first + 2u];
    return Asked(Force(a.xyz, b.xyz), Motion(vec3(a.w, b.w, c.w), c.xyz));
}

Force loadPassedForce(uint joint)
{
    uint first = sweepEntry(joint, SWEEP_PASSED);
    return Force(jointSweeps[first].xyz, jointSweeps[first + 1u].xyz);
}

void storePassedForce(uint joint, Force f)
{
    uint first = sweepEntry(joint, SWEEP_PASSED);
    jointSweeps[first].xyz = f.t;
    jointSweeps[first + 1u].xyz = f.r;
}

/// @param part SWEEP_MOTION or SWEEP_TOTAL, as of the next two.
Motion loadMotion(uint joint, uint part)
{
    uint first = sweepEntry(joint, part);
    return Motion(jointSweeps[first].xyz, jointSweeps[first + 1u].xyz);
}

void storeMotion(uint joint, uint part, Motion m)
{
    uint first = sweepEntry(joint, part);
    jointSweeps[first].xyz = m.t;
    jointSweeps[first + 1u].xyz = m.r;
}

void addMotion(uint joint, uint part, Motion m)
{
    uint first = sweepEntry(joint, part);
    jointSweeps[first].xyz += m.t;
    jointSweeps[first + 1u].xyz += m.r;
}
