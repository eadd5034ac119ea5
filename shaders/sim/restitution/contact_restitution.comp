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
#ifdef LEDGER
BUFFER(vec4, PairLedgers, pairLedgers);
#else
BUFFER(vec4, PairRestitutions, pairRestitutions);
#endif
READ_BUFFER(Counters, CountersBlock, counters);

#ifdef LEDGER
/// Gains, and how much more of both sides' loss to the solver the first may give back than its own loss [J].
/// @param solver its impulse on the first side [kg m/s].
vec4 ledgerOf(uvec2 movers, vec3 rA, vec3 rB, vec3 normal, Impulse last, float now, vec3 solver)
{
    vec3 solvedA = velocitySolved(movers.x, rA), solvedB = velocitySolved(movers.y, rB);
    float solved = dot(normal, solvedA - solvedB), sum = max(last.normal, 0.0);
    if (!responds(movers.x) || !responds(movers.y)) return vec4(gainOf(sum, solved, now, 1.0), 0, 0);
    Arrival a = arrivalOf(movers.x, rA), b = arrivalOf(movers.y, rB);
    vec3 before = a.velocity + b.velocity + sim.substepTime * (a.pull + b.pull);
    return vec4(gainOf(sum, solved, now, 0.5), 0.25 * dot(solver, before + solvedA + solvedB), 0);
}
#endif

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    uint index = counters[0].listParity * sim.pairCapacity + q;
    Pair pair = fetchPair(pairs, index);
    ContactSides sides = fetchContactSides(pairSides, q);
    uint first = sides.movers.x, second = sides.movers.y;
    Arm armA = fetchContactArm(pairArms, firstArm(q)), armB = fetchContactArm(pairArms, secondArm(q));
    vec4 rotationA = fetchRotation(first), rotationB = fetchRotation(second);
    vec3 between = fetchCentre(first) - fetchCentre(second);
    vec3 particles = between + (rotate(rotationA, fetchArm(pair.first).r) - rotate(rotationB, fetchArm(pair.second).r));
    References refs = referencesOf(pair, sides.movers, radiusExcess(sides.movers), sides.exit.sameAssembly, particles,
                                   rotationA, rotationB);
    vec3 difference = between + (rotate(rotationA, refs.a.r) - rotate(rotationB, refs.b.r));
    vec3 normal = separationOf(difference, exitOf(refs, sides.exit), rotationA, rotationB, sides.hidden,
                               refs.a.radius + refs.b.radius).normal;
    Impulse last = fetchImpulse(lastPairRestitutions, index);
    vec3 now = velocityNow(first, armA.r) - velocityNow(second, armB.r);
#if defined(LEDGER)
    pairLedgers[q] = ledgerOf(sides.movers, armA.r, armB.r, normal, last, dot(normal, now),
                              fetchImpulse(pairImpulses, index).whole / sim.substepTime);
#elif defined(SHARE)
    vec3 solver = fetchImpulse(pairImpulses, index).whole / sim.substepTime;
    vec2 shares = min(restitutionShares(first), restitutionShares(second));
    pairRestitutions[index] = packImpulse(sharedRestitution(last, normal, solver, shares));
#else
    float approach = approachOf(arrivalOf(first, armA.r), arrivalOf(second, armB.r), normal);
    vec2 splits = vec2(restitutionSplits(first), restitutionSplits(second));
    float inverseMass = dot(splits * vec2(armA.worstInverseMass, armB.worstInverseMass), sides.fractions);
    float restitution = max(fetchMass(pair.first).restitution, fetchMass(pair.second).restitution);
    pairRestitutions[index] = packImpulse(solveRestitution(last, fetchImpulse(pairImpulses, index).normal, normal,
                                                           approach, now, inverseMass, restitution));
#endif
}
