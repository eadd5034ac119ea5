// One thread a contact between particles: one Jacobi iteration of its impulse. mover_solve gives it to both sides.
#include "sim/common/kernel.glsl"
#include "sim/common/movers.glsl"
#include "sim/common/list_ranges.glsl"
#include "sim/contact/contact_impulse.glsl"
#include "sim/common/flat_faces.glsl"

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
    uvec2 movers = sides.xy & MOVER_MASK;
    MoverPoint a = moverPoint(movers.x, armA.xyz), b = moverPoint(movers.y, armB.xyz);
    vec3 startApart = a.centre - b.centre + (a.arm - b.arm);
    Contact contact;
    contact.slide = a.move - b.move;
    vec3 r = startApart + contact.slide;
    float far = length(r);
    Way way = unpackWay(sides.xy);
    Parting parting = partingOf(startApart, way, texelFetch(moverRotations, int(movers.x)),
                                texelFetch(moverRotations, int(movers.y)), unpackHidden(sides.w));
    contact.normal = parting.keeps ? parting.normal : contactNormal(r, far, true);
    contact.kin = way.kin;
    contact.leaving = max(dot(a.move, contact.normal), -dot(b.move, contact.normal));
    contact.startGap = (parting.sided && way.deep ? 0.0 : parting.far) - sim.diameter;
    contact.gap = parting.keeps ? contact.startGap + dot(contact.slide, parting.normal) : far - sim.diameter;
    vec2 worst = vec2(armA.w * a.splits, armB.w * b.splits);
    contact.worstMass = worst.x + worst.y;
    contact.inverseMass = dot(worst, unpackFractions(sides.w));
    contact.friction = unpackHalf2x16(sides.z);
    uint place = counters[0].listParity * sim.pairCapacity + q;
    float mean = texelFetch(lastPairMeans, int(place)).x;
    pairImpulses[place] = solveContact(contact, texelFetch(lastPairImpulses, int(place)), mean);
    pairMeans[place] = mean;
}
