// What the kernels of pressures know of the particle in each slot, besides sim/fluid/slot_values.glsl.
#include "math/upper_halves.glsl"

uniform samplerBuffer slotMoves;
uniform samplerBuffer slotShapes;
uniform usamplerBuffer slotPressures;

/// From where it was predicted to be in the last substep to where it is in this one.
struct SlotMove {
    vec3 move;        // [m]
    bool isNew;       // it has come in this step
};

SlotMove fetchSlotMove(uint slot)
{
    vec4 t = texelFetch(slotMoves, int(slot));
    return SlotMove(t.xyz, t.w > 0.0);
}

vec4 pack(SlotMove s)
{
    return vec4(s.move, s.isNew ? 1.0 : 0.0);
}

/// What evens the stress of its pressure, as of the last fluid_shape.
mat3 fetchSlotShape(uint slot)
{
    vec3 s = texelFetch(slotShapes, int(2u * slot)).xyz, t = texelFetch(slotShapes, int(2u * slot + 1u)).xyz;
    return mat3(s, s.y, t.xy, s.z, t.yz);
}

/// The multiplier of its density constraint.
struct SlotPressure {
    vec3 position;    // the position that the multiplier was computed for [m]
    mat3 lambda;      // multiplier times fetchSlotShape(): symmetric [kg m2]
};

/// A multiplier that is 2^-8 of the largest that one particle of water can have, so that halves keep small ones
/// [kg m2].
float lambdaUnit()
{
    float spacing = sim.fluidSpacing;
    return 1000.0 / 256.0 * spacing * spacing * spacing / (100.0 * sim.fluidSoftness);
}

/// Two elements beside the diagonal have 16 bits, so that it needs two texels.
uvec4 firstHalf(SlotPressure s)
{
    return uvec4(floatBitsToUint(s.position), packUpper(vec2(s.lambda[0].y, s.lambda[0].z) / lambdaUnit()));
}

uvec4 secondHalf(SlotPressure s)
{
    return floatBitsToUint(vec4(s.lambda[0].x, s.lambda[1].y, s.lambda[2].z, s.lambda[1].z) / lambdaUnit());
}

vec3 fetchPressurePosition(uint slot)
{
    return uintBitsToFloat(texelFetch(slotPressures, int(2u * slot)).xyz);
}

/// Its multiplier is in units of lambdaUnit().
SlotPressure fetchSlotPressure(uint slot)
{
    uvec4 s = texelFetch(slotPressures, int(2u * slot));
    vec4 t = uintBitsToFloat(texelFetch(slotPressures, int(2u * slot + 1u)));
    vec2 h = unpackUpper(s.w);
    return SlotPressure(uintBitsToFloat(s.xyz), mat3(t.x, h.x, h.y, h.x, t.y, t.w, h.y, t.w, t.z));
}

/// An evened multiplier across solids, or its mean where their slopes cancel.
float evenAcross(mat3 even, vec3 gradient)
{
    float least = 0.02 / (sim.fluidReach * sim.fluidReach), mean = (even[0].x + even[1].y + even[2].z) / 3.0;
    return (dot(gradient, even * gradient) + least * mean) / (dot(gradient, gradient) + least);
}
