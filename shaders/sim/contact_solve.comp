// One thread a contact between particles: one Jacobi iteration of its impulse. mover_solve gives it to both sides.
#include "shared/kernel.glsl"
#include "shared/movers.glsl"
#include "shared/list_ranges.glsl"
#include "shared/contact_impulse.glsl"
#include "shared/one_sided.glsl"

layout(local_size_x = GROUP_SIZE) in;
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
    uvec4 sides = texelFetch(pairSides, int(q));
    vec4 armA = texelFetch(pairArms, int(2u * q)), armB = texelFetch(pairArms, int(2u * q + 1u));
    MoverPoint a = moverPoint(sides.x & MOVER_MASK, armA.xyz), b = moverPoint(sides.y & MOVER_MASK, armB.xyz);
    vec3 startApart = a.centre - b.centre + (a.arm - b.arm);
    Contact contact;
    contact.slide = a.move - b.move;
    vec3 r = startApart + contact.slide;
    float far = length(r), startFar = length(startApart);
    Way way = unpackWay(sides.xy);
    vec4 sided = sidedNormal(startApart, startFar, way);
    bool oneSided = sided.w > 0.0;
    contact.normal = oneSided ? sided.xyz : contactNormal(r, far, true);
    contact.kin = way.kin;
    contact.leaving = max(dot(a.move, contact.normal), -dot(b.move, contact.normal));
    contact.startGap = oneSided && way.deep ? -step.diameter : startFar - step.diameter;
    contact.gap = oneSided ? contact.startGap + dot(contact.slide, sided.xyz) : far - step.diameter;
    vec2 worst = vec2(armA.w * a.splits, armB.w * b.splits);
    contact.worstMass = worst.x + worst.y;
    contact.inverseMass = dot(worst, unpackUnorm2x16(sides.w));
    contact.friction = unpackHalf2x16(sides.z);
    uint place = counters[0].listParity * step.pairCapacity + q;
    float mean = texelFetch(lastPairMeans, int(place)).x;
    pairImpulses[place] = solveContact(contact, texelFetch(lastPairImpulses, int(place)), mean);
    pairMeans[place] = mean;
}
