// Stacks: bodies without joints that touch each other, for whose contacts all at once are solved
// (sim/solver/contact/stack_stage.h). STACKS: of a world where there may be any.
#include "shared/stack_records.h"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/contacts/round_bodies.glsl"

uniform usamplerBuffer stackParents;

/// What a body hangs on in its stack, and with which others it forms loops.
uvec4 stackNeighbours(uint m)
{
    return texelFetch(stackParents, int(m));
}

uint stackParent(uint m)
{
    return stackNeighbours(m).x;
}

/// Whether a body is solved with its stack.
bool inStack(uint m)
{
#ifdef STACKS
    return stackParent(m) != NONE;
#else
    return false;
#endif
}

/// Whether a mover of parent `parent` in its stack meets a body, no ball or capsule, that only stands in the way.
bool standsOn(uint parent, uint other)
{
    return parent != NONE && other < sim.bodyCount && !responds(other) && fetchRound(other).radius == 0.0;
}

/// Whether the contacts of two movers are solved with their stack.
bool pairInStack(uvec2 movers)
{
#ifdef STACKS
    uvec4 a = stackNeighbours(movers.x), b = stackNeighbours(movers.y);
    return any(equal(a, uvec4(movers.y))) || any(equal(b, uvec4(movers.x))) || standsOn(a.x, movers.y) ||
           standsOn(b.x, movers.x);
#else
    return false;
#endif
}
