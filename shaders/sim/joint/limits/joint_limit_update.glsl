// Which stops hold: those that their joint leans on or has passed.
#include "sim/joint/limits/joint_limit_stiffness.glsl"

/// Where a substep begins all are looked for; later in it, those that have come to hold or pull.
#ifdef AGAIN
const bool BEGINS = false;
#else
const bool BEGINS = true;
#endif
/// Whether a rigid stop that pulls lets go. It shows once what its body hangs on and touches has answered; in the last
/// iteration nobody would see where that leads.
#if defined(AGAIN) && !defined(LAST)
const bool LETS_GO = true;
#else
const bool LETS_GO = false;
#endif

/// How far within its limit a stop that held may be and go on holding [rad].
const float TOUCH = 0.005;
/// The part of that which a substep leaves: the rest brings the joint nearer to its limit.
const float LEANING = 0.9;
/// What turns onto a stop no faster than this leans on it [rad/s].
const float MOST_LEANING = 1.0;

/// A stop that held in the substep before goes on holding, from where it is: if those of a chain were all looked for
/// anew, they would hold in one substep and not in the next. @param memory the part of what it held that is left.
void beginLimit(inout JointLimitState s, int i, float excess, bool rigid, float memory)
{
    if (excess < -TOUCH) s.hardness[i] = 0.0;
    bool goesOn = rigid && s.hardness[i] > 0.0;
    s.kept[i] = rigid ? keptOfExcess(max(excess, 0.0)) : 0.0;
    if (goesOn && excess < 0.0) s.kept[i] = LEANING * excess;
    s.held[i] *= goesOn ? memory : 0.0;
}

/// @param start its excess when the substep began. @returns whether it holds now and did not, or the other way round.
bool updateLimit(inout JointLimitState s, int i, vec3 axis, float excess, float start, bool rigid)
{
    bool held = s.hardness[i] > 0.0, holds = excess > s.kept[i];
    if (held) holds = (rigid && !LETS_GO) || s.held[i] + s.hardness[i] * (excess - s.kept[i]) > 0.0;
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
bool hasStopped(JointLimitState s, int i, float excess, float start)
{
    return s.hardness[i] > 0.0 && excess - start > MOST_LEANING * sim.substepTime;
}

/// @returns whether another set of stops of a joint holds than before.
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
    // As with contacts: second order would answer what stops it one and a half times. What only leans on it may be
    // thrown back as far as that is.
    if ((swing && hasStopped(s, 0, now.swing, first.swing)) || (turn && hasStopped(s, 1, now.turn, first.turn)))
        assemblies[fetchMover(joint.body).assembly].order = 1u;
    return swing || turn;
}

/// @returns whether another set of stops of a tree holds than before.
bool updateLimits(JointTree tree)
{
    bool changed = false;
    for (uint k = tree.first; k < tree.end; ++k) changed = updateJointLimits(k) || changed;
    return changed;
}
