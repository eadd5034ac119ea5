// What a mover is, and whether it answers to impulses.
#include "sim/common/bodies/sleep.glsl"

uniform usamplerBuffer moverInfo;
uniform usamplerBuffer moverStates;      // MOVER_*

MoverInfo fetchMover(uint m)
{
    uvec4 t = texelFetch(moverInfo, int(m));
    return MoverInfo(t.x, t.y, t.z, uintBitsToFloat(t.w));
}

/// Whether nothing ever moves it. Its mass is uploaded all the same: only this says so.
bool isFixed(uint m)
{
    return texelFetch(moverStates, int(m)).x == MOVER_FIXED;
}

/// Whether a mover answers to what acts on it: not while it is fixed or its assembly sleeps.
bool responds(uint m, uint assembly)
{
    return !isFixed(m) && !isAsleep(assembly);
}
