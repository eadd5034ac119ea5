// One thread a stack: a Newton step of all its bodies at once, eliminated from the ends of its tree to its root.
// BEGINS, ENDS: the steps of an iteration. FIRST: those of a substep. AGAIN: of an iteration after the first.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/stacks.glsl"
#include "sim/contact/stack/stack_blocks.glsl"
#include "sim/contact/stack/stack_loads.glsl"
#include "sim/contact/stack/stack_steps.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
READ_BUFFER(uvec4, StackSizes, stackSizes);
READ_BUFFER(uvec2, StackRanges, stackRanges);
READ_BUFFER(uint, StackTouches, stackTouches);

/// Takes a body out of its stack: what it and all that hangs on it are for its parent.
void eliminate(uint body)
{
    Inertia inertia = loadInertia(body, STACK_OWN);
    Force force = loadForce(body, STACK_FORCE);
    addOwn(body, inertia, force);
    for (uint k = 0u; k < STACK_TOUCHES; ++k) {
        uint child = stackTouches[STACK_TOUCHES * body + k];
        if (child == NONE) break;
        if (stackParent(child) != body) continue;
        inertia = add(inertia, loadInertia(child, STACK_PASSED));
        force = add(force, loadForce(child, STACK_ON_PARENT));
    }
    storeInertia(body, STACK_OWN, inertia);
    storeForce(body, STACK_FORCE, force);
    uint parent = stackParent(body);
    if (parent == STACK_ROOT) return;
    FactoredInertia factors = factored(add(inertia, loadInertia(body, STACK_EDGE)));
    vec3 arm = centreNow(parent) - centreNow(body);
    Force passed = less(force, product(inertia, solve(factors, force)));
    storeInertia(body, STACK_PASSED, shifted(inSeries(inertia, factors), arm));
    storeForce(body, STACK_ON_PARENT, add(loadForce(body, STACK_ON_PARENT), shifted(passed, arm)));
}

/// How a body moves, once that of its parent is known. @returns how far [rad and diameters].
float answer(uint body)
{
    Inertia inertia = loadInertia(body, STACK_OWN);
    Force force = loadForce(body, STACK_FORCE);
    uint parent = stackParent(body);
    if (parent != STACK_ROOT) {
        Inertia edge = loadInertia(body, STACK_EDGE);
        vec3 arm = centreNow(body) - centreNow(parent);
        force = add(force, product(edge, shifted(loadStep(parent), arm)));
        inertia = add(inertia, edge);
    }
    Motion motion = solve(factored(inertia), force);
    storeForce(body, STACK_STEP, Force(motion.t, motion.r));
    return length(motion.r) + length(motion.t) / sim.diameter;
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= stackSizes[STACKS_SIZE].w) return;
    uvec2 range = stackRanges[index];
    if (!inStack(stackOrder[range.x])) return;
#ifdef BEGINS
    for (uint k = range.x; k < range.y; ++k) note(stackOrder[k]);
#endif
    for (uint k = range.x; k < range.y; ++k) eliminate(stackOrder[k]);
    float size = 0.0;
    for (uint k = range.y; k-- > range.x;) size = max(size, answer(stackOrder[k]));
    for (uint k = range.x; k < range.y; ++k) {
        if (size < MOST_STEP) move(stackOrder[k]);
        else giveUp(stackOrder[k]);
    }
}
