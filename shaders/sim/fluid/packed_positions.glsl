// Positions in the fluids' grid packed into 32 bits: ten bits an axis, wrapped every four cells, and whether they are
// of solid particles. Neighbours are less than two cells apart, so their difference is unambiguous.

#define QUANTA_PER_CELL 256.0
#define PACKED_QUANTUM 4194304.0   // a quantum in packedSquare()
#define PACKED_SOLID 0x40000000u

uint packPosition(vec3 x, bool solid)
{
    uvec3 q = uvec3(ivec3(floor(x * (sim.inverseFluidCell * QUANTA_PER_CELL)))) & 1023u;
    return q.x | q.y << 10 | q.z << 20 | (solid ? PACKED_SOLID : 0u);
}

/// The coordinates, each in its ten highest bits, so that a difference of two wraps as positions do.
uvec3 packedCoordinates(uint code)
{
    return uvec3(code << 22, (code << 12) & 0xffc00000u, (code << 2) & 0xffc00000u);
}

/// The squared distance of two positions, a quantum being PACKED_QUANTUM. An axis is wrong by less than one quantum.
float packedSquare(uvec3 a, uvec3 b)
{
    vec3 r = vec3(ivec3(a - b));
    return dot(r, r);
}
