// Density that walls and solids add in each slot; see slot_values.glsl.

uniform samplerBuffer slotWalls;
uniform samplerBuffer slotSolids;
uniform samplerBuffer slotCovered;

/// The share of its kernel that walls and solids cover.
float fetchSlotCovered(uint slot)
{
    return texelFetch(slotCovered, int(slot)).x;
}

/// Density that walls and everything else add.
struct SlotWallCover {
    vec3 gradient;    // of the density constraint, from walls [1/m]
    float density;    // total density over the density at rest
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

/// Density that solid particles add.
struct SlotSolidCover {
    vec3 gradient;    // of the density constraint, from solids [1/m]
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
