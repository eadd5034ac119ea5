// One thread a contact between particles: one Jacobi iteration of the impulse that makes it bounce.
#include "sim/common/kernel.glsl"
#include "sim/restitution/restitution.glsl"
#include "sim/common/list_ranges.glsl"
#include "sim/common/flat_faces.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer pairs;
uniform usamplerBuffer pairSides;
uniform samplerBuffer pairArms;
uniform samplerBuffer pairImpulses;
uniform samplerBuffer masses;            // y: restitution
uniform samplerBuffer lastPairRestitutions;
BUFFER(vec4, PairRestitutions, pairRestitutions);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    int place = int(counters[0].listParity * sim.pairCapacity + q);
    uvec4 sides = texelFetch(pairSides, int(q));
    uvec2 movers = sides.xy & MOVER_MASK;
    uvec2 pair = texelFetch(pairs, place).xy;
    vec4 armA = texelFetch(pairArms, int(2u * q)), armB = texelFetch(pairArms, int(2u * q + 1u));
    PointState a = pointState(movers.x, armA.xyz), b = pointState(movers.y, armB.xyz);
    vec4 turnA = texelFetch(moverRotations, int(movers.x)), turnB = texelFetch(moverRotations, int(movers.y));
    vec3 apart = a.position - b.position;
    vec3 normal = partingOf(apart, unpackWay(sides.xy), turnA, turnB, unpackHidden(sides.w)).normal;
    vec3 before = velocityBefore(movers.x, armA.xyz) - velocityBefore(movers.y, armB.xyz);
    vec2 splits = vec2(texelFetch(moverRestitutionSplits, int(movers.x)).x, texelFetch(moverRestitutionSplits, int(movers.y)).x);
    float inverseMass = dot(splits * vec2(armA.w, armB.w), unpackFractions(sides.w));
    float restitution = max(texelFetch(masses, int(pair.x)).y, texelFetch(masses, int(pair.y)).y);
    pairRestitutions[place] = solveRestitution(texelFetch(lastPairRestitutions, place), texelFetch(pairImpulses, place).w, normal,
                                     before, a.velocity - b.velocity, inverseMass, restitution);
}
