// Joints that close loops in a tree: each is a force between two of its bodies. How far that moves them apart is found
// by trying it (joint_loop_factor); then forces of all loops of a tree correct their errors (joint_loop_solve).
#include "shared/joint_records.h"
#include "sim/joint/joint_sweeps.glsl"
#include "sim/joint/loops/loop_passes.glsl"

/// How the ends of a loop answer to forces between them.
struct LoopFactor {
    Inertia apart;     // motion of its ends per force, factored as an inverse
    vec3 arm;          // from the body's centre to the joint [m]
    vec3 parentArm;    // from its parent's
    vec3 axis;         // of a hinge
    Motion kept;       // the part of its error that this substep does not correct
    // How far it gives: invisibly little, but if the tree holds its ends already, its force would otherwise grow
    // without bound.
    float givenMove;   // [1/kg]
    float givenTurn;   // [1/(kg m2)]
};

/// In World's joints, those that close loops come after the trees'.
uint loopEntry(uint loop)
{
    return LOOP_FACTOR_TEXELS * (loop - sim.treeJointCount);
}

#define STORE_LOOP_FACTOR(factors, loop, f) \
    factors[loopEntry(loop)] = vec4(diagonalOf((f).apart.a), (f).arm.x); \
    factors[loopEntry(loop) + 1u] = vec4(offDiagonalOf((f).apart.a), (f).arm.y); \
    factors[loopEntry(loop) + 2u] = vec4(diagonalOf((f).apart.d), (f).arm.z); \
    factors[loopEntry(loop) + 3u] = vec4(offDiagonalOf((f).apart.d), (f).parentArm.x); \
    factors[loopEntry(loop) + 4u] = vec4((f).apart.b[0], (f).parentArm.y); \
    factors[loopEntry(loop) + 5u] = vec4((f).apart.b[1], (f).parentArm.z); \
    factors[loopEntry(loop) + 6u] = vec4((f).apart.b[2], (f).axis.x); \
    factors[loopEntry(loop) + 7u] = vec4((f).kept.t, (f).axis.y); \
    factors[loopEntry(loop) + 8u] = vec4((f).kept.r, (f).axis.z); \
    factors[loopEntry(loop) + 9u].xy = vec2((f).givenMove, (f).givenTurn);

#define LOOP_FACTOR_FROM(GET) \
    LoopFactor(Inertia(symmetricMatrix(GET(0).xyz, GET(1).xyz), mat3(GET(4).xyz, GET(5).xyz, GET(6).xyz), \
                       symmetricMatrix(GET(2).xyz, GET(3).xyz)), \
               vec3(GET(0).w, GET(1).w, GET(2).w), vec3(GET(3).w, GET(4).w, GET(5).w), \
               vec3(GET(6).w, GET(7).w, GET(8).w), Motion(GET(7).xyz, GET(8).xyz), GET(9).x, GET(9).y)

/// Whether a loop is between a body and its child in the tree: it stands in for the joint between the two while the
/// child does not respond, since the tree's joint then holds only what hangs on the child.
bool standsIn(Joint joint)
{
    return joint.parentJoint != NONE && fetchJoint(joint.parentJoint).parent == joint.body;
}

/// Whether a loop holds anything now.
bool loopActs(uint loop)
{
    Joint joint = fetchJoint(loop);
    bool body = responds(joint.body), parent = responds(joint.parent);
    return fetchFreedom(loop) != JOINT_NONE && (standsIn(joint) ? body && !parent : body || parent);
}

/// From the leaves to the root, passes only the force between the ends of a loop.
void passLoopForce(JointTree tree, uint loop, vec3 arm, vec3 parentArm, Force f)
{
    Motion none = Motion(vec3(0), vec3(0));
    Joint joint = fetchJoint(loop);
    for (uint k = tree.end; k-- > tree.first;) {
        Force own = Force(vec3(0), vec3(0));
        if (k == joint.bodyJoint) own = shifted(f, -arm);
        if (k == joint.parentJoint) own = add(own, shifted(Force(-f.t, -f.r), -parentArm));
        passForce(k, own, none, vec3(0));
    }
}

/// How far the ends of a loop have moved apart. @param part of the tree's motions, SWEEP_MOTION or SWEEP_TOTAL.
Motion loopMotion(uint loop, vec3 arm, vec3 parentArm, uint part)
{
    Joint joint = fetchJoint(loop);
    Motion a = shifted(loadMotion(joint.bodyJoint, part), arm), b = Motion(vec3(0), vec3(0));
    if (joint.parentJoint != NONE) b = shifted(loadMotion(joint.parentJoint, part), parentArm);
    return Motion(a.t - b.t, a.r - b.r);
}
