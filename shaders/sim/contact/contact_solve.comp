// One thread a contact between particles: one Jacobi iteration of its impulse. mover_solve gives it to both sides.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/contacts/touch.glsl"
#include "sim/contact/contact_impulse.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer pairs;
uniform usamplerBuffer pairSides;
uniform samplerBuffer pairArms;
uniform samplerBuffer lastPairImpulses;
uniform samplerBuffer lastPairMeans;
BUFFER(vec4, PairImpulses, pairImpulses);
BUFFER(float, PairMeans, pairMeans);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    uint index = counters[0].listParity * sim.pairCapacity + q;
    Pair pair = fetchPair(pairs, index);
    ContactSides sides = fetchContactSides(pairSides, q);
    Arm armA = fetchContactArm(pairArms, firstArm(q)), armB = fetchContactArm(pairArms, secondArm(q));
    MoverPoint a = moverPoint(sides.movers.x, armA.r), b = moverPoint(sides.movers.y, armB.r);
    vec3 startDifference = a.centre - b.centre + (a.arm - b.arm);
    Contact contact;
    contact.touch = touchDistance(pair.first, pair.second);
    contact.slide = a.move - b.move;
    vec3 difference = startDifference + contact.slide;
    float apart = length(difference);
    Separation start = separationOf(startDifference, sides.exit, fetchRotation(sides.movers.x),
                                    fetchRotation(sides.movers.y), sides.hidden, contact.touch);
    contact.normal = start.keepsNormal ? start.normal : contactNormal(difference, apart);
    contact.sameAssembly = sides.exit.sameAssembly;
    contact.leaving = max(dot(a.move, contact.normal), -dot(b.move, contact.normal));
    contact.startGap = (start.oneSided && sides.exit.deepInside ? 0.0 : start.distance) - contact.touch;
    contact.gap = start.keepsNormal ? contact.startGap + dot(contact.slide, start.normal) : apart - contact.touch;
    vec2 worst = vec2(armA.worstInverseMass * a.splits, armB.worstInverseMass * b.splits);
    contact.worstInverseMass = worst.x + worst.y;
    contact.inverseMass = dot(worst, sides.fractions);
    contact.friction = sides.friction;
    float mean = texelFetch(lastPairMeans, int(index)).x;
    pairImpulses[index] = packImpulse(solveContact(contact, fetchImpulse(lastPairImpulses, index), mean));
    pairMeans[index] = mean;
}
