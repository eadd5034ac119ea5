// Which stops hold: those that their joint leans on or has passed.
#include "sim/joint/joint_stop_stiffness.glsl"

/// As long as a stop that held is no further away from its limit than this, it may go on to [rad].
const float TOUCH = 0.005;
/// It comes as much nearer in a substep.
const float LEANING = 0.9;
/// What turns onto a stop no faster than this leans on it [rad/s].
const float MOST_LEANING = 1.0;

/// Where a substep begins: a stop that held goes on to, from where it is. Where those that hold a chain were all looked
/// for anew, they would hold in one substep and not in the next. @param memory the part of what it held that is left.
void beginStop(inout JointStop s, int i, float excess, bool rigid, float memory)
{
    if (excess < -TOUCH) s.hardness[i] = 0.0;
    bool goesOn = rigid && s.hardness[i] > 0.0;
    s.kept[i] = rigid ? keptOfExcess(max(excess, 0.0)) : 0.0;
    if (goesOn && excess < 0.0) s.kept[i] = LEANING * excess;
    s.held[i] *= goesOn ? memory : 0.0;
}

/// @param start its excess when the substep began. @param mayLetGo whether a rigid one that pulls lets go.
/// @returns whether it holds now and did not, or the other way round.
bool updateStop(inout JointStop s, int i, vec3 axis, float excess, float start, bool mayLetGo, bool rigid)
{
    bool held = s.hardness[i] > 0.0, holds = excess > s.kept[i];
    if (held) holds = (rigid && !mayLetGo) || s.held[i] + s.hardness[i] * (excess - s.kept[i]) > 0.0;
    if (holds && held && dot(axis, s.axes[i]) < 0.0) s.held[i] = 0.0;   // the other end of its range
    s.axes[i] = axis;
    if (!holds) s.hardness[i] = s.held[i] = 0.0;
    if (holds && !held) {
        s.hardness[i] = 1.0;
        // What would pass it is stopped where it is; a way to go in one substep would be its speed after it.
        if (rigid) s.kept[i] = min(s.kept[i], start);
    }
    return holds != held;
}

/// Whether a stop that has come to hold has stopped a turn, and not just been leaned on.
bool hasStopped(JointStop s, int i, float excess, float start)
{
    return s.hardness[i] > 0.0 && excess - start > MOST_LEANING * sim.substepTime;
}

/// @param start whether a substep begins. @param mayLetGo whether rigid ones that pull let go. @returns whether another
/// set of stops holds than before.
bool updateStops(uint k, bool start, bool mayLetGo)
{
    JointLimits limits = fetchJointLimits(k);
    JointInfo joint = fetchJoint(k);
    if (!isLimited(limits) || fetchFreedom(k) == JOINT_NONE || !responds(joint.body)) return false;
    JointSide body = jointSide(k, 0u, joint.body), parent = jointSide(k, 1u, joint.parent);
    JointStop s = fetchStop(k);
    bool rigid = limits.stiffness == 0.0;
    Excess first = excessOver(limits, parent.startFrame, body.startFrame);
    if (start) {
        float memory = texelFetch(lastJointStops, int(JOINT_STOP_TEXELS * k + STOP_TORQUE)).w;
        beginStop(s, 0, first.swing, rigid, memory);
        beginStop(s, 1, first.turn, rigid, memory);
    }
    Excess now = excessOver(limits, parent.frame, body.frame);
    bool swing = updateStop(s, 0, now.swingAxis, now.swing, first.swing, mayLetGo, rigid);
    bool turn = updateStop(s, 1, now.turnAxis, now.turn, first.turn, mayLetGo, rigid);
    storeStop(k, s);
    // As with contacts: second order would answer what stops it one and a half times. What only leans on it may be
    // thrown back as far as that is.
    if ((swing && hasStopped(s, 0, now.swing, first.swing)) || (turn && hasStopped(s, 1, now.turn, first.turn)))
        assemblies[fetchMover(joint.body).assembly].order = 1u;
    return swing || turn;
}

/// Of a tree. Whether one pulls shows once what its body hangs on and touches has answered. In the last iteration none
/// lets go: nobody would see where that leads.
bool updateStops(JointTree tree)
{
    bool start = false, mayLetGo = true;
#ifndef AGAIN
    start = true;
    mayLetGo = false;
#elif defined(LAST)
    mayLetGo = false;
#endif
    bool changed = false;
    for (uint k = tree.first; k < tree.end; ++k) changed = updateStops(k, start, mayLetGo) || changed;
    return changed;
}
