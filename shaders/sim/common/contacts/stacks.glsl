// Stacks: bodies without joints whose touches form a tree, for whose contacts all at once are solved
// (sim/solver/contact/stack_stage.h). STACKS: of a world where there may be any.
#include "shared/stack_records.h"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/contacts/round_bodies.glsl"

uniform usamplerBuffer stackParents;

uint stackParent(uint m)
{
    return texelFetch(stackParents, int(m)).x;
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
    uint a = stackParent(movers.x), b = stackParent(movers.y);
    return a == movers.y || b == movers.x || standsOn(a, movers.y) || standsOn(b, movers.x);
#else
    return false;
#endif
}
