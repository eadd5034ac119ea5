// Where limits stop a joint: at most two turns at once, out of its cone and about its axis. A stop is a spring that
// only pushes back and is solved with the joints of its tree; a rigid one remembers what it held, so that it does not
// give in the end.
#include "sim/common/bodies/assemblies.glsl"
#include "sim/joint/joint_pose.glsl"
#include "sim/joint/joint_recovery.glsl"

uniform samplerBuffer jointLimits;     // swing, lowest and highest turn [rad]; stiffness [N m/rad], 0: rigid
// As the dispatch before left them; llvmpipe reads these three times as fast.
uniform samplerBuffer lastJointLimitStates;
BUFFER(vec4, JointLimitStates, newJointLimitStates);

/// The axes of the swing's and of the turn's stop, about which the body turns further beyond it; and the hardness of
/// each, 0 if it does not hold [kg m2]. What each holds [kg m2], how much of its excess is kept [rad]. What both add to
/// the joint now; and the part of what they hold that is left in the next substep.
#define LIMIT_AXES 0u
#define LIMIT_HELD 2u
#define LIMIT_TORQUE 3u

const float PI = 3.14159265;

JointRange fetchJointLimits(uint joint)
{
    vec4 t = texelFetch(jointLimits, int(joint));
    return JointRange(t.x, t.y, t.z, t.w);
}

bool isLimited(JointRange limits)
{
    return limits.swing < PI || limits.highest < PI || limits.lowest > -PI;
}

/// How far a joint exceeds its limits, negative within them, and the turn of its body that leads further out.
struct Excess {
    vec3 swingAxis, turnAxis;
    float swing, turn;   // [rad]
};

float wrapped(float angle)
{
    return angle - 2.0 * PI * round(angle / (2.0 * PI));
}

/// A turn is a swing of the axis and then a turn about it; the latter is about the middle of both places of the axis.
/// @param from, to the joint's axes in the parent and in the body.
Excess excessOver(JointRange limits, vec4 from, vec4 to)
{
    vec3 middle = rotate(from, vec3(1, 0, 0)), axis = rotate(to, vec3(1, 0, 0)), across = cross(middle, axis);
    vec4 turn = quaternionProduct(conjugate(from), to);
    float along = dot(middle, axis), sine = length(across);
    Excess b = Excess(vec3(0), vec3(0), -4.0, -4.0);
    if (limits.swing < PI && sine > 1e-6) {
        b.swing = atan(sine, along) - limits.swing;
        b.swingAxis = across / sine;
    }
    // With a swing by half a turn, the turn about the axis is undetermined.
    if ((limits.highest < PI || limits.lowest > -PI) && along > -0.98) {
        float centre = 0.5 * (limits.lowest + limits.highest);
        float angle = centre + wrapped(2.0 * atan(turn.x, turn.w) - centre);
        bool above = angle > centre;
        b.turn = above ? angle - limits.highest : limits.lowest - angle;
        b.turnAxis = (above ? 1.0 : -1.0) / (1.0 + along) * (middle + axis);
    }
    return b;
}

struct JointLimitState {
    vec3 axes[2];
    float hardness[2];   // [kg m2]
    float held[2];       // [kg m2]
    float kept[2];       // [rad]
};

/// The state before this dispatch.
JointLimitState fetchLimitState(uint joint)
{
    int first = int(JOINT_LIMIT_TEXELS * joint);
    vec4 swing = texelFetch(lastJointLimitStates, first + int(LIMIT_AXES));
    vec4 turn = texelFetch(lastJointLimitStates, first + int(LIMIT_AXES) + 1);
    vec4 held = texelFetch(lastJointLimitStates, first + int(LIMIT_HELD));
    return JointLimitState(vec3[2](swing.xyz, turn.xyz), float[2](swing.w, turn.w), float[2](held.x, held.y),
                     float[2](held.z, held.w));
}

void storeLimitState(uint joint, JointLimitState s)
{
    uint first = JOINT_LIMIT_TEXELS * joint;
    for (int i = 0; i < 2; ++i) newJointLimitStates[first + LIMIT_AXES + uint(i)] = vec4(s.axes[i], s.hardness[i]);
    newJointLimitStates[first + LIMIT_HELD] = vec4(s.held[0], s.held[1], s.kept[0], s.kept[1]);
}

vec3 torqueOf(JointLimitState s)
{
    return -s.held[0] * s.axes[0] - s.held[1] * s.axes[1];
}
