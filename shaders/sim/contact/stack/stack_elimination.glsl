// The elimination of a stack's bodies along its tree, as if there were no loops.
READ_BUFFER(uint, StackTouches, stackTouches);

#define FOR_CHILDREN(body, child) \
    for (uint n = 0u, child; n < STACK_TOUCHES && (child = stackTouches[STACK_TOUCHES * body + n]) != NONE; ++n) \
        if (stackParent(child) == body)

/// Takes a body out of its stack: how it and all that hangs on it resist its parent.
void eliminate(uint body)
{
    Inertia inertia = loadInertia(body, STACK_OWN);
    FOR_CHILDREN(body, child) inertia = add(inertia, loadInertia(child, STACK_PASSED));
    storeInertia(body, STACK_OWN, inertia);
    uint parent = stackParent(body);
    if (parent == STACK_ROOT) return;
    FactoredInertia factors = factored(add(inertia, loadInertia(body, STACK_EDGE)));
    storeInertia(body, STACK_PASSED, shifted(inSeries(inertia, factors), centreNow(parent) - centreNow(body)));
}

/// What its parent feels of a force on it, and on all that hangs on it. @param besides of what else it feels.
void passForce(uint body, Force force, Force besides)
{
    Inertia inertia = loadInertia(body, STACK_OWN);
    FactoredInertia factors = factored(add(inertia, loadInertia(body, STACK_EDGE)));
    Force passed = less(force, product(inertia, solve(factors, force)));
    vec3 arm = centreNow(stackParent(body)) - centreNow(body);
    storeForce(body, STACK_ON_PARENT, add(besides, shifted(passed, arm)));
}

/// How a body moves, once that of its parent is known.
void answer(uint body)
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
}

/// Forces on bodies before anything moves, and their own inertias. Without loops, what children push by is left to
/// passForce().
void gather(uvec2 range, uint loops)
{
    for (uint k = range.x; k < range.y; ++k) {
        uint body = stackOrder[k];
        Inertia inertia = loadInertia(body, STACK_OWN);
        Force force = loadForce(body, STACK_FORCE);
        addOwn(body, inertia, force);
        if (loops > 0u) FOR_CHILDREN(body, child) force = add(force, loadForce(child, STACK_ON_PARENT));
        storeInertia(body, STACK_OWN, inertia);
        storeForce(body, STACK_RESIDUAL, force);
    }
    for (uint k = range.x; k < range.y; ++k) {
        uint body = stackOrder[k];
        FOR_LOOPS(body, loop, partner)
            addForce(partner, STACK_RESIDUAL, loadForce(body, loopRecord(loop) + STACK_ON_PARTNER));
    }
}

/// How the tree alone answers to the forces left.
void answerAll(uvec2 range, uint loops)
{
    for (uint k = range.x; k < range.y; ++k) {
        uint body = stackOrder[k];
        Force force = loadForce(body, STACK_RESIDUAL);
        FOR_CHILDREN(body, child) force = add(force, loadForce(child, STACK_ON_PARENT));
        storeForce(body, STACK_FORCE, force);
        if (stackParent(body) == STACK_ROOT) continue;
        Force besides = Force(vec3(0), vec3(0));
        if (loops == 0u) besides = loadForce(body, STACK_ON_PARENT);
        passForce(body, force, besides);
    }
    for (uint k = range.y; k-- > range.x;) answer(stackOrder[k]);
}
