// How the lists of neighbours lie in slotNeighbours: four in a texel, those of NEIGHBOUR_BLOCK slots next to each other.

/// The texel of a slot's neighbours 4 four .. 4 four + 3. The next four are NEIGHBOUR_BLOCK texels further.
uint neighbourTexel(uint slot, uint four)
{
    return (slot / NEIGHBOUR_BLOCK * (sim.fluidSlots / 4u) + four) * NEIGHBOUR_BLOCK + slot % NEIGHBOUR_BLOCK;
}
