// One thread a contact between particles: one Jacobi iteration of the impulse that makes it bounce.
#include "sim/common/kernel.glsl"
#include "sim/restitution/restitution.glsl"
#include "sim/common/contacts/contact_point.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer pairs;
uniform usamplerBuffer pairSides;
uniform samplerBuffer pairArms;
uniform samplerBuffer pairImpulses;
uniform samplerBuffer lastPairRestitutions;
BUFFER(vec4, PairRestitutions, pairRestitutions);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    uint index = counters[0].listParity * sim.pairCapacity + q;
    Pair pair = fetchPair(pairs, index);
    ContactSides sides = fetchContactSides(pairSides, q);
    uint first = sides.movers.x, second = sides.movers.y;
    Arm armA = fetchContactArm(pairArms, firstArm(q)), armB = fetchContactArm(pairArms, secondArm(q));
    PointState a = pointState(first, armA.r), b = pointState(second, armB.r);
    vec4 rotationA = fetchRotation(first), rotationB = fetchRotation(second);
    vec3 between = fetchCentre(first) - fetchCentre(second);
    vec3 particles = between + (rotate(rotationA, fetchArm(pair.first).r) - rotate(rotationB, fetchArm(pair.second).r));
    References refs = referencesOf(pair, sides.movers, sides.exit.sameAssembly, particles, rotationA, rotationB);
    vec3 difference = between + (rotate(rotationA, refs.a.r) - rotate(rotationB, refs.b.r));
    vec3 normal = separationOf(difference, exitOf(refs, sides.exit), rotationA, rotationB, sides.hidden,
                               refs.a.radius + refs.b.radius).normal;
    vec3 before = velocityBefore(first, armA.r) - velocityBefore(second, armB.r);
    vec2 splits = vec2(restitutionSplits(first), restitutionSplits(second));
    float inverseMass = dot(splits * vec2(armA.worstInverseMass, armB.worstInverseMass), sides.fractions);
    float restitution = max(fetchMass(pair.first).restitution, fetchMass(pair.second).restitution);
    pairRestitutions[index] = packImpulse(
        solveRestitution(fetchImpulse(lastPairRestitutions, index), fetchImpulse(pairImpulses, index).normal, normal,
                         before, a.velocity - b.velocity, inverseMass, restitution));
}
