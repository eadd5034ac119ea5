// Decides which stops hold: those that their joint leans on or has passed.
#include "sim/joint/limits/joint_limit_stiffness.glsl"

/// A substep begins by checking all stops; later, it checks those that have come to hold or pull.
#ifdef AGAIN
const bool BEGINS = false;
#else
const bool BEGINS = true;
#endif
/// Whether a rigid stop that pulls lets go. That it pulls shows only once the bodies around have answered; in the last
/// iteration nothing could answer to letting go.
#if defined(AGAIN) && !defined(LAST)
const bool LETS_GO = true;
#else
const bool LETS_GO = false;
#endif

/// How far within its limit a stop that held may be and still hold [rad].
const float TOUCH = 0.005;
/// The part of that distance that a substep leaves: the rest brings the joint nearer to its limit.
const float LEANING = 0.9;
/// A joint that turns onto a stop no faster than this leans on it [rad/s].
const float MOST_LEANING = 1.0;

/// A stop that held in the substep before continues to hold, from where it is: if the stops of a chain were all checked
/// anew, they would hold in every other substep. @param memory the part of what it held that is left.
void beginLimit(inout JointLimitState s, int i, float excess, bool rigid, float memory)
{
    if (excess < -TOUCH) s.hardness[i] = 0.0;
    bool goesOn = rigid && s.hardness[i] > 0.0;
    s.kept[i] = rigid ? keptOfExcess(max(excess, 0.0)) : 0.0;
    if (goesOn && excess < 0.0) s.kept[i] = LEANING * excess;
    s.held[i] *= goesOn ? memory : 0.0;
}

/// @param start its excess when the substep began. @returns whether it has begun or ceased to hold.
bool updateLimit(inout JointLimitState s, int i, vec3 axis, float excess, float start, bool rigid)
{
    bool held = s.hardness[i] > 0.0, holds = excess > s.kept[i];
    if (held) holds = (rigid && !LETS_GO) || s.held[i] + s.hardness[i] * (excess - s.kept[i]) > 0.0;
    if (holds && held && dot(axis, s.axes[i]) < 0.0) s.held[i] = 0.0;   // the other end of its range
    s.axes[i] = axis;
    if (!holds) s.hardness[i] = s.held[i] = 0.0;
    if (holds && !held) {
        s.hardness[i] = 1.0;
        // A joint that would pass a stop is stopped where it is; a way to go in one substep would become its speed.
        if (rigid) s.kept[i] = min(s.kept[i], start);
    }
    return holds != held;
}

/// Whether a stop that has come to hold has stopped a turn, rather than just been leaned on.
bool hasStopped(JointLimitState s, int i, float excess, float start)
{
    return s.hardness[i] > 0.0 && excess - start > MOST_LEANING * sim.substepTime;
}

/// @returns whether the set of a joint's stops that hold has changed.
bool updateJointLimits(uint k)
{
    JointRange limits = fetchJointLimits(k);
    Joint joint = fetchJoint(k);
    if (!isLimited(limits) || fetchFreedom(k) == JOINT_NONE || !responds(joint.body)) return false;
    JointSide body = jointSide(k, 0u, joint.body), parent = jointSide(k, 1u, joint.parent);
    JointLimitState s = fetchLimitState(k);
    bool rigid = limits.stiffness == 0.0;
    Excess first = excessOver(limits, parent.startFrame, body.startFrame);
    if (BEGINS) {
        float memory = texelFetch(lastJointLimitStates, int(JOINT_LIMIT_TEXELS * k + LIMIT_TORQUE)).w;
        beginLimit(s, 0, first.swing, rigid, memory);
        beginLimit(s, 1, first.turn, rigid, memory);
    }
    Excess now = excessOver(limits, parent.frame, body.frame);
    bool swing = updateLimit(s, 0, now.swingAxis, now.swing, first.swing, rigid);
    bool turn = updateLimit(s, 1, now.turnAxis, now.turn, first.turn, rigid);
    storeLimitState(k, s);
    // As with contacts, second order would answer to the stop one and a half times. A joint that only leans on the stop
    // may be thrown back that far.
    if ((swing && hasStopped(s, 0, now.swing, first.swing)) || (turn && hasStopped(s, 1, now.turn, first.turn)))
        assemblies[fetchMover(joint.body).assembly].order = 1u;
    return swing || turn;
}

/// @returns whether the set of a tree's stops that hold has changed.
bool updateLimits(JointTree tree)
{
    bool changed = false;
    for (uint k = tree.first; k < tree.end; ++k) changed = updateJointLimits(k) || changed;
    return changed;
}
