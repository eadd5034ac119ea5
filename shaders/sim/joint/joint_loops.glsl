// Joints that close loops in a tree: each is a force between two of its bodies. How far that moves them apart is found by
// trying it (joint_loop_factor); then each loop of a tree in turn corrects its error (joint_solve).

/// How far the ends of a loop come apart for what it holds: too little to be seen, but where the tree holds them already,
/// what the loop holds would else grow without end.
struct LoopGive {
    float move;   // [1/kg]
    float turn;   // [1/(kg m2)]
};

/// A loop has no use for what its joint lets turn.
void storeGive(inout JointFactor factor, LoopGive give)
{
    factor.free = mat3(give.move, 0, 0, 0, give.turn, 0, 0, 0, 0);
}

LoopGive loadGive(JointFactor factor)
{
    return LoopGive(factor.free[0][0], factor.free[1][1]);
}

/// From the leaves to the root, with no other force than that between the ends of a loop.
void passLoopForce(JointTree tree, uint loop, JointFactor factor, Force f)
{
    Motion none = Motion(vec3(0), vec3(0));
    uint bodyJoint = fetchJointRows(loop).bodyJoint, parentJoint = fetchTreeJoint(loop).parentJoint;
    for (uint k = tree.end; k-- > tree.first;) {
        Force own = Force(vec3(0), vec3(0));
        if (k == bodyJoint) own = shifted(f, -factor.arm);
        if (k == parentJoint) own = add(own, shifted(Force(-f.t, -f.r), -factor.parentArm));
        passForce(k, own, none, vec3(0));
    }
}

/// How far the ends of a loop have moved apart. @param slot of the tree's motions.
Motion loopMotion(uint loop, JointFactor factor, uint slot)
{
    Motion a = shifted(loadMotion(fetchJointRows(loop).bodyJoint, slot), factor.arm), b = Motion(vec3(0), vec3(0));
    uint parentJoint = fetchTreeJoint(loop).parentJoint;
    if (parentJoint != NONE) b = shifted(loadMotion(parentJoint, slot), factor.parentArm);
    return Motion(a.t - b.t, a.r - b.r);
}
