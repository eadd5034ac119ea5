// What is known of a geared hinge, and of the part of its train that hangs together: hinges behind a torn one are
// coupled with those before it no more.
#include "sim/joint/joint_info.glsl"

READ_BUFFER(GearedHinge, GearHinges, gearHinges);
BUFFER(vec4, GearStates, gearStates);   // GEAR_STATE_TEXELS each

struct GearState {
    float angle;    // when last looked at [rad]
    float off;      // by how much it is turned further than its train
    float torque;   // of all its gears [N m]
    float way;      // turn per torque [1/(kg m2)]; 0: it does not answer
};

GearState loadGearState(uint hinge)
{
    vec4 t = gearStates[GEAR_STATE_TEXELS * hinge];
    return GearState(t.x, t.y, t.z, t.w);
}

void storeGearState(uint hinge, GearState s)
{
    gearStates[GEAR_STATE_TEXELS * hinge] = vec4(s.angle, s.off, s.torque, s.way);
}

/// Over what hangs together; kept by the first of it.
struct GearSums {
    float off;      // of r off / way
    float torque;   // of r T
    float ways;     // of r^2 / way; -1: one of them leads, and -off is how far
};

GearSums loadGearSums(uint head)
{
    vec4 t = gearStates[GEAR_STATE_TEXELS * head + 1u];
    return GearSums(t.x, t.y, t.z);
}

void storeGearSums(uint head, GearSums s)
{
    gearStates[GEAR_STATE_TEXELS * head + 1u].xyz = vec3(s.off, s.torque, s.ways);
}

uint loadHead(uint hinge)
{
    return floatBitsToUint(gearStates[GEAR_STATE_TEXELS * hinge + 1u].w);
}

void storeHead(uint hinge, uint head)
{
    gearStates[GEAR_STATE_TEXELS * hinge + 1u].w = uintBitsToFloat(head);
}

bool isTorn(uint hinge)
{
    return fetchFreedom(gearHinges[hinge].joint) == JOINT_NONE;
}

/// The first of what hangs together with a hinge, where those before it know theirs.
uint headOf(uint hinge)
{
    uint before = gearHinges[hinge].before;
    return before == NONE || isTorn(hinge) || isTorn(before) ? hinge : loadHead(before);
}
