// What a mover is, and its state: whether it answers to impulses, and whether it moves. Kernels ask no more than that;
// only the room `sleep` knows why something rests.

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

/// Whether a mover answers to what acts on it. Only this says so: its mass is set in any case.
bool responds(uint m)
{
    return texelFetch(moverStates, int(m)).x == MOVER_DYNAMIC;
}

/// Whether a mover answers to nothing until it is let go. Two of these make no contact, except where it matters what
/// they touch (TOUCHES).
bool isTold(uint m)
{
#ifdef TOUCHES
    return false;
#else
    uint state = texelFetch(moverStates, int(m)).x;
    return state == MOVER_ANIMATED || state == MOVER_FIXED;
#endif
}

/// Whether a mover moves: one that responds does, and an animated one moves as its clip says.
bool moves(uint m)
{
    return texelFetch(moverStates, int(m)).x <= MOVER_ANIMATED;
}
