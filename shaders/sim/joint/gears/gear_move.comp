// One thread a tree of joints, after gear_solve: the tree answers to what the torques of gears have changed by. LIMITS:
// where joints are limited.
#define MANY_PUSHES
#define ANGULAR
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/joint/joint_error.glsl"
#include "sim/joint/joint_rows.glsl"
#include "sim/joint/joint_sweeps.glsl"
#ifdef LIMITS
#include "sim/joint/limits/joint_limit_solve.glsl"
#endif

layout(local_size_x = TREE_GROUP_SIZE) in;
READ_BUFFER(float, GearAsked, gearAsked);
READ_BUFFER(uint, GearedHingeOf, gearedHingeOf);   // of each joint of the trees; NONE

float askedOf(uint k)
{
    uint hinge = gearedHingeOf[k];
    return hinge == NONE ? 0.0 : gearAsked[hinge];
}

bool isAsked(JointTree tree)
{
    for (uint k = tree.first; k < tree.end; ++k)
        if (askedOf(k) != 0.0) return true;
    return false;
}

void pass(uint k)
{
    Motion none = Motion(vec3(0), vec3(0));
    float asked = askedOf(k);
    passForce(k, Force(vec3(0), vec3(0)), none, asked == 0.0 ? vec3(0) : asked * fetchJointFactor(k).axis);
}

void take(uint k)
{
    Answer answer = follow(k);
#ifdef LIMITS
    answer.held.r += limitTorqueOf(k, answer, 1.0);
#endif
    pushBoth(k, answer.held);
    moveBody(fetchJoint(k).body, answer.motion);
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (treeRests(tree) || !isAsked(tree)) return;
    for (uint k = tree.end; k-- > tree.first;) pass(k);
    for (uint k = tree.first; k < tree.end; ++k) take(k);
}
