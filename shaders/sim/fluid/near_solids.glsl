// Bits of cells near solid particles.

/// Which word of fluidNearSolids, and which bit of it.
uvec2 nearSolidsBit(uint cell)
{
    uint group = cell / CELLS_ALONG;
    return uvec2(group / 32u, 1u << (group & 31u));
}
