// Which stops hold: those that their joint leans on or has passed.
#include "sim/joint/joint_stops.glsl"

BUFFER(Assembly, AssemblyState, assemblies);

/// What a stop may be away from its limit and still lean on it [rad].
const float TOUCH = 1e-4;
/// What turns onto a stop no faster than this leans on it [rad/s].
const float MOST_LEANING = 1.0;

/// Where a substep begins: what was thrown back, or is still on its way, does not lean on it.
void beginStop(inout JointStop s, int i, float excess, bool rigid)
{
    s.kept[i] = rigid ? keptOfTurn(max(excess, 0.0)) : 0.0;
    if (excess < -TOUCH) s.hardness[i] = s.held[i] = 0.0;
}

/// @param start its excess when the substep began. @returns whether it holds now and did not, or the other way round.
bool updateStop(inout JointStop s, int i, vec3 axis, float excess, float start, bool rigid)
{
    bool held = s.hardness[i] > 0.0;
    bool holds = held ? s.held[i] + s.hardness[i] * (excess - s.kept[i]) > 0.0 : excess > s.kept[i];
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

/// @param start whether a substep begins. @returns whether another set of stops holds than before.
bool updateStops(uint k, bool start)
{
    JointLimits limits = fetchJointLimits(k);
    JointInfo joint = fetchJoint(k);
    if (!isLimited(limits) || fetchFreedom(k) == JOINT_NONE || !responds(joint.body)) return false;
    JointSide body = jointSide(k, 0u, joint.body), parent = jointSide(k, 1u, joint.parent);
    JointStop s = fetchStop(k);
    bool rigid = limits.stiffness == 0.0;
    Excess first = excessOver(limits, parent.startFrame, body.startFrame);
    if (start) {
        beginStop(s, 0, first.swing, rigid);
        beginStop(s, 1, first.turn, rigid);
    }
    Excess now = excessOver(limits, parent.frame, body.frame);
    bool swing = updateStop(s, 0, now.swingAxis, now.swing, first.swing, rigid);
    bool turn = updateStop(s, 1, now.turnAxis, now.turn, first.turn, rigid);
    storeStop(k, s);
    // As with contacts: second order would answer what stops it one and a half times. What only leans on it may be
    // thrown back as far as that is.
    if ((swing && hasStopped(s, 0, now.swing, first.swing)) || (turn && hasStopped(s, 1, now.turn, first.turn)))
        assemblies[fetchMover(joint.body).assembly].order = 1u;
    return swing || turn;
}

/// @returns whether another set of stops of a tree holds than before.
bool updateStops(JointTree tree, bool start)
{
    bool changed = false;
    for (uint k = tree.first; k < tree.end; ++k) changed = updateStops(k, start) || changed;
    return changed;
}

/// What a joint's stops add to its resistance to turns: a rigid one, much more than the body with all that hangs on it
/// has by itself. @param inertia against turns about the joint [kg m2]
mat3 stopStiffness(uint k, mat3 inertia)
{
    const float RIGID = 100.0;
    JointLimits limits = fetchJointLimits(k);
    if (!isLimited(limits)) return mat3(0);
    float factor = accelerationFactor(assemblies[fetchMover(fetchJoint(k).body).assembly]);
    mat3 resistance = mat3(0);
    for (uint i = 0u; i < 2u; ++i) {
        uint stop = JOINT_STOP_TEXELS * k + STOP_AXES + i;
        vec4 axis = newJointStops[stop];   // w: hardness
        if (axis.w == 0.0) continue;
        axis.w = limits.stiffness > 0.0 ? limits.stiffness * factor * sim.substepTime * sim.substepTime
                                        : RIGID * dot(axis.xyz, inertia * axis.xyz);
        newJointStops[stop].w = axis.w;
        resistance += outerProduct(axis.w * axis.xyz, axis.xyz);
    }
    return resistance;
}
