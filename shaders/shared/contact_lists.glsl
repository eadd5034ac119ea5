// The lists of contact candidates: slot s of particle i. Two halves in turn, so that a new search can look up the
// impulses of the old lists.

uint contactSlot(uint parity, uint slot, uint i)
{
    return ((parity * (step.contactSlots + COLLIDER_SLOTS)) + slot) * step.particleCount + i;
}

/// Slots from step.contactSlots on hold colliders.
uint colliderSlot(uint parity, uint slot, uint i)
{
    return contactSlot(parity, step.contactSlots + slot, i);
}

/// From b to a, for two points at most a rounding error apart: up for the first, down for the second.
vec3 contactNormal(vec3 difference, float distance, uint i, uint j)
{
    return distance > 1e-7 ? difference / distance : vec3(0, i < j ? 1.0 : -1.0, 0);
}
