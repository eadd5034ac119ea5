// One thread a body of a stack: adds what its contacts with colliders push it by, beyond the impulses that they had,
// and how stiff they are. STORE: at the end of a substep, keeps their impulses.
// No ball, capsule or grain is in a stack, and what they need are textures too many.
#undef ROUNDS
#undef GRAINS
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/contact/collider_now.glsl"
#include "sim/common/contacts/list_ranges.glsl"
#include "sim/common/contacts/stacks.glsl"
#include "sim/contact/stack/stack_blocks.glsl"
#include "sim/contact/stack/stack_push.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer colliderPairs;
uniform usamplerBuffer colliderSides;
READ_BUFFER(vec4, ColliderArms, colliderArms);
READ_BUFFER(uvec4, StackSizes, stackSizes);
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(vec4, ColliderImpulses, colliderImpulses);
#ifdef STORE
BUFFER(float, ColliderMeans, colliderMeans);
#include "sim/common/bodies/assemblies.glsl"
BUFFER(Assembly, AssemblyState, assemblies);
#endif

void visit(uint body, uint q, uint parity, inout Inertia stiffness, inout Force force)
{
    uint index = parity * sim.colliderPairCapacity + q;
    Impulse last = unpackImpulse(colliderImpulses[index]);
    uint particle = fetchColliderPair(colliderPairs, index).particle;
    ColliderContact sides = fetchColliderContact(colliderSides, q);
    vec4 delta = fetchRotationDelta(body), rotation = quaternionProduct(delta, fetchRotation(body));
    ColliderNow now = colliderNow(particle, body, sides.collider, radiusExcess(body), rotation);
    if (last.normal <= 0.0 && now.startGap > FAR_APART * sim.diameter) return;
    vec3 arm = rotate(rotation, now.ref.r) + now.offset;
    vec3 startArm = rotate(conjugate(delta), arm);
    vec3 slide = movedByTurn(fetchMove(body).shift, delta, startArm) - now.surfaceWay;
    Push push = pushOf(now.normal, now.startGap, slide, sides.friction, stiffnessOf(fetchMover(body)), last);
#ifdef STORE
    colliderImpulses[index] = packImpulse(keptOf(push, stiffnessOf(fetchMover(body)), now.startGap));
    colliderMeans[index] = push.normal;
    if (push.normal > 0.0) assemblies[fetchMover(body).assembly].lastContact = counters[0].substep - 1u;
#else
    force = add(force, forceAt(arm, push.impulse));
    force = add(force, forceAt(rotate(rotation, colliderArms[q].xyz), -last.whole));
    stiffness = add(stiffness, stiffnessAt(arm, push.stiffness));
#endif
}

void main()
{
    if (gl_GlobalInvocationID.x >= stackSizes[STACK_BODIES_SIZE].w) return;
    uint body = stackOrder[gl_GlobalInvocationID.x], parity = counters[0].listParity;
    if (!inStack(body)) return;
    Mover mover = fetchMover(body);
    uvec2 range = listRange(parity, LIST_COLLIDERS, mover.firstRank, mover.rankCount);
    Inertia stiffness = noInertia();
    Force force = Force(vec3(0), vec3(0));
    for (uint q = range.x; q < range.y; ++q) visit(body, q, parity, stiffness, force);
#ifndef STORE
    storeInertia(body, STACK_OWN, add(stiffness, loadInertia(body, STACK_OWN)));
    storeForce(body, STACK_FORCE, add(force, loadForce(body, STACK_FORCE)));
#endif
}
