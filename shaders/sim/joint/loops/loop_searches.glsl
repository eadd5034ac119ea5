// Where the search for the forces of loops is, and what they pull bodies by.
#include "sim/joint/loops/joint_loops.glsl"

uniform samplerBuffer loopFactors;
FLOAT_TEXELS(loopSearches)   // per loop LOOP_SEARCH_TEXELS
FLOAT_TEXELS(loopPulls)      // per joint of a tree, two: what its loops pull its body by

#define FOR_ACTING_LOOPS(tree, loop) \
    for (uint loop = tree.firstLoop; loop < tree.loopEnd; ++loop) \
        if (loopActs(loop))

// Of a loop, two texels each.
#define SEARCH_WRONG 0u      // what it is wrong by, a motion
#define SEARCH_FORCE 2u      // the force on its ends so far
#define SEARCH_ALONG 4u      // the force that is tried
#define SEARCH_MOVED 6u      // how far that moves its ends; then the force by which it would be right alone

LoopFactor fetchLoopFactor(uint loop)
{
    int first = int(loopEntry(loop));
#define TEXEL(k) texelFetch(loopFactors, first + k)
    return LOOP_FACTOR_FROM(TEXEL);
#undef TEXEL
}

int searchTexel(uint loop, uint part)
{
    return int(LOOP_SEARCH_TEXELS * (loop - sim.treeJointCount) + part);
}

Force loadSearch(uint loop, uint part)
{
    int first = searchTexel(loop, part);
    return Force(imageLoad(loopSearches, first).xyz, imageLoad(loopSearches, first + 1).xyz);
}

void storeSearch(uint loop, uint part, vec3 t, vec3 r)
{
    int first = searchTexel(loop, part);
    imageStore(loopSearches, first, vec4(t, 0));
    imageStore(loopSearches, first + 1, vec4(r, 0));
}

Force loadPull(uint k)
{
    return Force(imageLoad(loopPulls, int(2u * k)).xyz, imageLoad(loopPulls, int(2u * k + 1u)).xyz);
}

void storePull(uint k, Force f)
{
    imageStore(loopPulls, int(2u * k), vec4(f.t, 0));
    imageStore(loopPulls, int(2u * k + 1u), vec4(f.r, 0));
}

void pullAt(uint k, Force f, vec3 arm)
{
    if (k != NONE) storePull(k, add(loadPull(k), shifted(f, -arm)));
}

/// From the leaves to the root, passes the forces between the ends of all loops.
void passLoopForces(JointTree tree, uint part)
{
    Force none = Force(vec3(0), vec3(0));
    for (uint k = tree.first; k < tree.end; ++k) storePull(k, none);
    FOR_ACTING_LOOPS(tree, loop) {
        LoopFactor factor = fetchLoopFactor(loop);
        Joint joint = fetchJoint(loop);
        Force f = loadSearch(loop, part);
        pullAt(joint.bodyJoint, f, factor.arm);
        pullAt(joint.parentJoint, Force(-f.t, -f.r), factor.parentArm);
    }
    for (uint k = tree.end; k-- > tree.first;) passForce(k, loadPull(k), Motion(vec3(0), vec3(0)), vec3(0));
}
