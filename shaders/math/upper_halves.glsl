// Two floats in a word by their upper halves, rounded: of 24 bits 8 are left. A software driver needs ten times as many
// instructions for packHalf2x16() and back.

uint packUpper(vec2 v)
{
    uvec2 u = floatBitsToUint(v) + 0x8000u;
    return (u.x & 0xffff0000u) | u.y >> 16;
}

vec2 unpackUpper(uint t)
{
    return uintBitsToFloat(uvec2(t & 0xffff0000u, t << 16));
}
