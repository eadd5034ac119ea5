// One thread a body of a stack: what its contacts with its parent, with the partners of its loops and with what stands
// still push it by, beyond the impulses that they had, and how stiff they are. STORE: at the end of a substep, keeps
// their impulses.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/contacts/list_ranges.glsl"
#include "sim/common/contacts/stacks.glsl"
#include "sim/contact/stack/stack_faces.glsl"
#include "sim/contact/stack/stack_loop_blocks.glsl"
#include "sim/contact/stack/stack_push.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer pairs;
uniform usamplerBuffer pairSides;
uniform usamplerBuffer pairReferences;
uniform samplerBuffer pairArms;
READ_BUFFER(uvec4, StackSizes, stackSizes);
READ_BUFFER(Counters, CountersBlock, counters);
FLOAT_TEXELS(pairImpulses)
#ifdef STORE
BUFFER(float, PairMeans, pairMeans);
#include "sim/common/bodies/assemblies.glsl"
BUFFER(Assembly, AssemblyState, assemblies);
#endif

struct Sums {
    Inertia edge, own;
    Force force, onParent;
};

void visit(uint body, uvec4 neighbours, uint q, uint parity, inout Sums sums)
{
    ContactSides sides = fetchContactSides(pairSides, q);
    bool first = sides.movers.x == body;
    uint other = first ? sides.movers.y : sides.movers.x, parent = neighbours.x;
    bvec3 loops = equal(neighbours.yzw, uvec3(other));
    bool answers = other == parent || any(loops);
    if (!answers && !standsOn(parent, other)) return;
    uint index = parity * sim.pairCapacity + q;
    Impulse last = unpackImpulse(imageLoad(pairImpulses, int(index)));
    float k = stiffnessOf(fetchMover(body)) + (answers ? stiffnessOf(fetchMover(other)) : 0.0);
    FacePair faces = facePair(fetchPair(pairs, index), sides, fetchContactArm(pairArms, firstArm(q)).r,
                              fetchContactArm(pairArms, secondArm(q)).r);
    if (last.normal <= 0.0 && faces.startGap > FAR_APART * sim.diameter) return;
    Side a = faces.a, b = faces.b;
    Push push = pushOf(faces.normal, faces.startGap, a.move - b.move, sides.friction, k, last);
#ifdef STORE
    imageStore(pairImpulses, int(index), packImpulse(keptOf(push, k, faces.startGap)));
    pairMeans[index] = push.normal;
    if (push.normal <= 0.0) return;
    assemblies[fetchMover(body).assembly].lastContact = counters[0].substep - 1u;
    if (answers) assemblies[fetchMover(other).assembly].lastContact = counters[0].substep - 1u;
#else
    // What the body was given already is taken back: it acts where it is kept, at the particles' centres.
    Force onA = add(forceAt(armNow(a), push.impulse), forceAt(a.kept, -last.whole));
    Force onB = add(forceAt(armNow(b), -push.impulse), forceAt(b.kept, last.whole));
    Inertia stiff = stiffnessAt(armNow(first ? a : b), push.stiffness);
    if (first) sums.force = add(sums.force, onA);
    else sums.force = add(sums.force, onB);
    if (other == parent) {
        sums.edge = add(sums.edge, stiff);
        if (first) sums.onParent = add(sums.onParent, onB);
        else sums.onParent = add(sums.onParent, onA);
    } else if (answers) {
        addToLoop(body, loops.x ? 0u : loops.y ? 1u : 2u, stiff, first ? onB : onA);
    } else {
        sums.own = add(sums.own, stiff);
    }
#endif
}

void main()
{
    if (gl_GlobalInvocationID.x >= stackSizes[STACK_BODIES_SIZE].w) return;
    uint body = stackOrder[gl_GlobalInvocationID.x], parity = counters[0].listParity;
    uvec4 neighbours = stackNeighbours(body);
    if (neighbours.x == NONE) return;
    Force none = Force(vec3(0), vec3(0));
    Sums sums = Sums(noInertia(), noInertia(), none, none);
#ifndef STORE
    FOR_LOOPS(body, loop, partner) clearLoop(body, loop);
#endif
    Mover mover = fetchMover(body);
    uvec2 range = listRange(parity, LIST_AS_FIRST, mover.firstRank, mover.rankCount);
    for (uint q = range.x; q < range.y; ++q) visit(body, neighbours, q, parity, sums);
    range = listRange(parity, LIST_AS_SECOND, mover.firstRank, mover.rankCount);
    for (uint k = range.x; k < range.y; ++k) {
        uint q = texelFetch(pairReferences, int(k)).x;
        if (q != NONE) visit(body, neighbours, q, parity, sums);
    }
#ifndef STORE
    storeInertia(body, STACK_EDGE, sums.edge);
    storeInertia(body, STACK_OWN, sums.own);
    storeForce(body, STACK_FORCE, sums.force);
    storeForce(body, STACK_ON_PARENT, sums.onParent);
#endif
}
