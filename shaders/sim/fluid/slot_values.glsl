// What the kernels of fluids know of the particle in each slot (sim/fluid/fluid_slots.glsl): fetch...() reads a struct,
// pack() converts it for storing. The samplers here have the buffers' names, so a kernel that stores into one of them
// calls its block new...
#include "math/upper_halves.glsl"
#include "sim/fluid/walls/slot_covers.glsl"

uniform samplerBuffer slotPositions;
uniform samplerBuffer slotVelocities;
uniform samplerBuffer slotVorticities;
uniform usamplerBuffer slotGradients;
uniform usamplerBuffer slotMaterials;

/// Where it is predicted to be at the end of the substep.
struct SlotPosition {
    vec3 position;    // [m]
    float mass;       // [kg]; not used for a solid particle
};

SlotPosition fetchSlotPosition(uint slot)
{
    vec4 t = texelFetch(slotPositions, int(slot));
    return SlotPosition(t.xyz, t.w);
}

vec4 pack(SlotPosition s)
{
    return vec4(s.position, s.mass);
}

/// Its velocity when the step began.
struct SlotVelocity {
    vec3 velocity;    // [m/s]
    float smoothing;  // FluidMaterial
};

SlotVelocity fetchSlotVelocity(uint slot)
{
    vec4 t = texelFetch(slotVelocities, int(slot));
    return SlotVelocity(t.xyz, t.w);
}

vec4 pack(SlotVelocity s)
{
    return vec4(s.velocity, s.smoothing);
}

/// The part of what differs from an even change around it that a step takes away.
float evenSmoothing(SlotVelocity s)
{
    return s.smoothing < 0.0 ? 0.0 : sim.evenSmoothing;
}

/// How the velocities around it change with place, times the part that a step evens: without its trace, as fluids
/// hardly change their volume.
struct SlotGradient {
    mat3 slope;
};

SlotGradient fetchSlotGradient(uint slot)
{
    uvec4 t = texelFetch(slotGradients, int(slot));
    vec2 a = unpackUpper(t.x), b = unpackUpper(t.y), c = unpackUpper(t.z), d = unpackUpper(t.w);
    return SlotGradient(mat3(a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y, -a.x - c.x));
}

uvec4 pack(SlotGradient s)
{
    mat3 m = s.slope - mat3((s.slope[0].x + s.slope[1].y + s.slope[2].z) / 3.0);
    return uvec4(packUpper(m[0].xy), packUpper(vec2(m[0].z, m[1].x)), packUpper(m[1].yz), packUpper(m[2].xy));
}

/// How the fluid around it swirls.
struct SlotVorticity {
    vec3 vorticity;   // [1/s]
    float size;       // its length
};

SlotVorticity fetchSlotVorticity(uint slot)
{
    vec4 t = texelFetch(slotVorticities, int(slot));
    return SlotVorticity(t.xyz, t.w);
}

vec4 pack(SlotVorticity s)
{
    return vec4(s.vorticity, s.size);
}

/// The material of the particle in a slot.
uint fetchSlotMaterial(uint slot)
{
    return texelFetch(slotMaterials, int(slot)).x;
}
