// What never changes about joints (sim/solver/layout/joint_trees.h). Joints that close loops stand behind all others.

uniform usamplerBuffer jointTrees;       // first joint, end; first loop, end
uniform usamplerBuffer jointBodies;      // body, its parent, the parent's joint, JOINT_*
uniform usamplerBuffer jointRows;        // of the channel: the body's, its parent's; first child, end, or the own joint
uniform samplerBuffer jointPlaces;       // four a joint: arm, the parent's; axes, the parent's

/// What joint_factor hands from a joint's body to its parent: so many texels of jointPassed.
#define JOINT_PASSED 6u

struct JointTree {
    uint first, end;           // joints, parents before children, those of one body together
    uint firstLoop, loopEnd;   // joints that close loops
};

JointTree fetchJointTree(uint tree)
{
    uvec4 t = texelFetch(jointTrees, int(tree));
    return JointTree(t.x, t.y, t.z, t.w);
}

struct TreeJoint {
    uint body, parent;   // parent is NONE of a root that nothing holds
    uint parentJoint;    // NONE where the parent is fixed
    uint freedom;        // JOINT_*
};

TreeJoint fetchTreeJoint(uint joint)
{
    uvec4 t = texelFetch(jointBodies, int(joint));
    return TreeJoint(t.x, t.y, t.z, t.w);
}

struct JointRows {
    uint row, parentRow;         // NONE where there is none
    uint firstChild, childEnd;   // joints that hang on its body
    uint bodyJoint;              // of one that closes a loop: its body's own
};

JointRows fetchJointRows(uint joint)
{
    uvec4 t = texelFetch(jointRows, int(joint));
    return JointRows(t.x, t.y, t.z, t.w, t.z);
}

/// Where a joint is in a body, in the body's axes.
struct JointPlace {
    vec3 arm;     // [m]
    vec4 frame;   // from the joint's axes; a hinge turns about x
};

/// @param side 0 for the body, 1 for its parent.
JointPlace fetchJointPlace(uint joint, uint side)
{
    int first = int(4u * joint + side);
    return JointPlace(texelFetch(jointPlaces, first).xyz, texelFetch(jointPlaces, first + 2));
}
