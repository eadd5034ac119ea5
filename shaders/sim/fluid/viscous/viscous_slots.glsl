// What the implicit solve of viscosity knows of the particle in each slot. A kernel that stores into one of these calls
// its block new...
#include "sim/fluid/fluid_slots.glsl"

uniform samplerBuffer slotStarts;
uniform samplerBuffer slotGoals;
uniform samplerBuffer slotGrips;

/// Where it was when the substep began: pair forces along the lines between these places keep angular momentum.
struct SlotStart {
    vec3 position;    // [m]
    float grip;       // of a fluid particle: how hard solids hold it [kg/m2]
};

SlotStart fetchSlotStart(uint slot)
{
    vec4 t = texelFetch(slotStarts, int(slot));
    return SlotStart(t.xyz, t.w);
}

vec4 pack(SlotStart s)
{
    return vec4(s.position, s.grip);
}

/// How it would end the substep without viscosity.
struct SlotGoal {
    vec3 velocity;        // [m/s]
    float inverseMass;    // [1/kg]; 0: it keeps that velocity
};

SlotGoal goalOf(vec4 t)
{
    return SlotGoal(t.xyz, t.w);
}

SlotGoal fetchSlotGoal(uint slot)
{
    return goalOf(texelFetch(slotGoals, int(slot)));
}

vec4 pack(SlotGoal s)
{
    return vec4(s.velocity, s.inverseMass);
}

/// The wall that it sticks to.
struct SlotGrip {
    vec3 velocity;    // of the wall [m/s]
    float grip;       // impulse over the difference of velocity [kg]
};

SlotGrip fetchSlotGrip(uint slot)
{
    vec4 t = texelFetch(slotGrips, int(slot));
    return SlotGrip(t.xyz, t.w);
}

vec4 pack(SlotGrip s)
{
    return vec4(s.velocity, s.grip);
}

/// An iterate of the solve.
struct SlotFlow {
    vec3 velocity;      // [m/s]
    float thickness;    // of a fluid particle: ViscousMaterial::thickness
};

SlotFlow flowOf(vec4 t)
{
    return SlotFlow(t.xyz, t.w);
}

vec4 pack(SlotFlow s)
{
    return vec4(s.velocity, s.thickness);
}
