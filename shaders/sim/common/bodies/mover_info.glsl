// What a mover is, and what it does now: whether it answers to impulses, and whether it moves. All kernels ask no more
// than that; only the room `sleep` knows why something rests.

uniform usamplerBuffer moverInfo;
uniform usamplerBuffer moverStates;      // MOVER_*

Mover fetchMover(uint m)
{
    uvec4 t = texelFetch(moverInfo, int(m));
    return Mover(t.x, t.y, t.z, uintBitsToFloat(t.w));
}

/// [kg]
float moverMass(uint m)
{
    return 1.0 / fetchMover(m).inverseMass;
}

/// Whether a mover answers to what acts on it. Its mass is there all the same: only this says so.
bool responds(uint m)
{
    return texelFetch(moverStates, int(m)).x == MOVER_DYNAMIC;
}

/// Whether a mover answers to nothing until somebody lets it go. Two of these are no contact, but
/// where it matters what they touch (TOUCHES).
bool isTold(uint m)
{
#ifdef TOUCHES
    return false;
#else
    uint state = texelFetch(moverStates, int(m)).x;
    return state == MOVER_ANIMATED || state == MOVER_FIXED;
#endif
}

/// Whether a mover moves: what responds does, and what is animated, as it is told.
bool moves(uint m)
{
    return texelFetch(moverStates, int(m)).x <= MOVER_ANIMATED;
}
