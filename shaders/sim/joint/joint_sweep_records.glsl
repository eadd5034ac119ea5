// Values that the sweeps over a tree pass to each other, per joint: what its body asks of its parent, what is asked of
// the body, its motion in this sweep, and, if joints close loops, its motion in all sweeps of a solve.
#include "shared/joint_records.h"
#include "sim/joint/short_sweeps.glsl"

#ifndef SHORT_TREES
// An image: a software driver reads and writes whole texels of it faster than those of a storage block.
layout(rgba32f) restrict uniform imageBuffer jointSweeps;

#define SWEEP_PASSED 0u
#define SWEEP_ASKED 2u
#define SWEEP_MOTION 5u
#define SWEEP_TOTAL 7u

uint sweepEntry(uint joint, uint part)
{
    return JOINT_SWEEP_TEXELS * joint + part;
}

void storeAsked(uint joint, Asked asked)
{
    int first = int(sweepEntry(joint, SWEEP_ASKED));
    imageStore(jointSweeps, first, vec4(asked.force.t, asked.error.t.x));
    imageStore(jointSweeps, first + 1, vec4(asked.force.r, asked.error.t.y));
    imageStore(jointSweeps, first + 2, vec4(asked.error.r, asked.error.t.z));
}

Asked loadAsked(uint joint)
{
    int first = int(sweepEntry(joint, SWEEP_ASKED));
    vec4 a = imageLoad(jointSweeps, first), b = imageLoad(jointSweeps, first + 1);
    vec4 c = imageLoad(jointSweeps, first + 2);
    return Asked(Force(a.xyz, b.xyz), Motion(vec3(a.w, b.w, c.w), c.xyz));
}

Force loadHandedForce(uint joint)
{
    int first = int(sweepEntry(joint, SWEEP_PASSED));
    return Force(imageLoad(jointSweeps, first).xyz, imageLoad(jointSweeps, first + 1).xyz);
}

void storeHandedForce(uint joint, Force f)
{
    int first = int(sweepEntry(joint, SWEEP_PASSED));
    imageStore(jointSweeps, first, vec4(f.t, 0));
    imageStore(jointSweeps, first + 1, vec4(f.r, 0));
}

/// @param part SWEEP_MOTION or SWEEP_TOTAL, as of the next two.
Motion loadMotion(uint joint, uint part)
{
    int first = int(sweepEntry(joint, part));
    return Motion(imageLoad(jointSweeps, first).xyz, imageLoad(jointSweeps, first + 1).xyz);
}

void storeMotion(uint joint, uint part, Motion m)
{
    int first = int(sweepEntry(joint, part));
    imageStore(jointSweeps, first, vec4(m.t, 0));
    imageStore(jointSweeps, first + 1, vec4(m.r, 0));
}

void addMotion(uint joint, uint part, Motion m)
{
    Motion before = loadMotion(joint, part);
    storeMotion(joint, part, Motion(before.t + m.t, before.r + m.r));
}

void storeSwept(uint joint, Motion m) { storeMotion(joint, SWEEP_MOTION, m); }

/// With the forces of what hangs on it.
Force withHanded(uint k, Joint joint, Force own)
{
    for (uint child = joint.firstChild; child < joint.childEnd; ++child) own = add(own, loadHandedForce(child));
    return own;
}

Motion motionOfParent(uint k, Joint joint)
{
    return loadMotion(joint.parentJoint, SWEEP_MOTION);
}
#endif
