// One thread a contact between particles: one Jacobi iteration of its impulse, which mover_solve adds to both sides.
// ROUNDS: of a world with balls or capsules, whose contacts act elsewhere in each iteration.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/contacts/stacks.glsl"
#include "sim/common/contacts/touch.glsl"
#include "sim/contact/pair_masses.glsl"
#ifdef ROUNDS
#include "sim/contact/round_pair.glsl"
#else
#include "sim/contact/particle_pair.glsl"
#endif

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer pairs;
uniform usamplerBuffer pairSides;
uniform samplerBuffer lastPairArms;
uniform samplerBuffer lastPairImpulses;
uniform samplerBuffer lastPairMeans;
#ifdef ROUNDS
FLOAT_TEXELS(newPairArms)
#endif
FLOAT_TEXELS(newPairImpulses)
BUFFER(float, PairMeans, pairMeans);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    uint index = counters[0].listParity * sim.pairCapacity + q;
    ContactSides sides = fetchContactSides(pairSides, q);
    if (pairInStack(sides.movers)) return;
    Impulse last = fetchImpulse(lastPairImpulses, index);
    Arm armA = fetchContactArm(lastPairArms, firstArm(q)), armB = fetchContactArm(lastPairArms, secondArm(q));
    Contact contact = pairNow(fetchPair(pairs, index), sides, armA, armB, last.normal);
    float mean = texelFetch(lastPairMeans, int(index)).x;
    imageStore(newPairImpulses, int(index), packImpulse(solveContact(contact, last, mean)));
    pairMeans[index] = mean;
#ifdef ROUNDS
    imageStore(newPairArms, int(firstArm(q)), packArm(armA));
    imageStore(newPairArms, int(secondArm(q)), packArm(armB));
#endif
}
