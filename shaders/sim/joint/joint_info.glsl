// What joints are (sim/solver/layout/joint_trees.h), and which of it may change. Joints that close loops come after all
// others.
#include "shared/joint_records.h"
#include "sim/common/bodies/mover_info.glsl"

uniform usamplerBuffer jointInfo;        // two texels each
uniform usamplerBuffer jointFreedoms;    // JOINT_*; JOINT_NONE for a torn joint, which holds nothing any more
uniform samplerBuffer jointPlaces;       // arm, the parent's; axes, the parent's
// Each thread reads it once, so this one is no texture: joint_solve has all 16.
READ_BUFFER(uvec4, JointTrees, jointTrees);   // first joint, end; first loop, end

struct JointTree {
    uint first, end;           // joints, parents before children, those of one body together
    uint firstLoop, loopEnd;   // joints that close loops
};

JointTree fetchJointTree(uint tree)
{
    uvec4 t = jointTrees[tree];
    return JointTree(t.x, t.y, t.z, t.w);
}

Joint fetchJoint(uint joint)
{
    uvec4 a = texelFetch(jointInfo, int(2u * joint)), b = texelFetch(jointInfo, int(2u * joint + 1u));
    return Joint(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w);
}

uint fetchFreedom(uint joint)
{
    return texelFetch(jointFreedoms, int(joint)).x;
}

/// Whether no body of a tree responds. If a body does not respond, neither does anything that it hangs on.
bool treeRests(JointTree tree)
{
    for (uint k = tree.first; k < tree.end; ++k)
        if (responds(fetchJoint(k).body)) return false;
    return true;
}

/// Where a joint is in a body, in the body's axes.
struct JointPlace {
    vec3 arm;     // [m]
    vec4 frame;   // from the joint's axes; a hinge turns about x
};

/// @param side 0 for the body, 1 for its parent.
JointPlace fetchJointPlace(uint joint, uint side)
{
    int first = int(JOINT_PLACE_TEXELS * joint + side);
    return JointPlace(texelFetch(jointPlaces, first).xyz, texelFetch(jointPlaces, first + 2));
}
