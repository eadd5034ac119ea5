// What walls and solids add to the density in each slot; as slot_values.glsl.

uniform samplerBuffer slotWalls;
uniform samplerBuffer slotSolids;

/// What walls and everything else add to its density.
struct SlotWallCover {
    vec3 gradient;    // of the density constraint, by what walls cover of the kernel [1/m]
    float density;    // over the density at rest, of all together
};

SlotWallCover fetchSlotWalls(uint slot)
{
    vec4 t = texelFetch(slotWalls, int(slot));
    return SlotWallCover(t.xyz, t.w);
}

vec4 pack(SlotWallCover s)
{
    return vec4(s.gradient, s.density);
}

/// What solid particles add to its density.
struct SlotSolidCover {
    vec3 gradient;    // of the density constraint, by what they cover of the kernel [1/m]
    float inverseWeight;   // one over the sum of solidWeight() over them; 0: there are none
};

SlotSolidCover fetchSlotSolids(uint slot)
{
    vec4 t = texelFetch(slotSolids, int(slot));
    return SlotSolidCover(t.xyz, t.w);
}

vec4 pack(SlotSolidCover s)
{
    return vec4(s.gradient, s.inverseWeight);
}
