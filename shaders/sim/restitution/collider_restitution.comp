// One thread a contact of a particle with a collider: one Jacobi iteration of the impulse that makes it bounce.
#include "sim/common/kernel.glsl"
#include "sim/restitution/restitution.glsl"
#include "sim/common/contacts/collider_moves.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer colliderPairs;
uniform usamplerBuffer colliderSides;
uniform samplerBuffer colliderArms;
uniform samplerBuffer colliderImpulses;
uniform samplerBuffer lastColliderRestitutions;
#ifdef LEDGER
BUFFER(vec4, ColliderLedgers, colliderLedgers);
#else
BUFFER(vec4, ColliderRestitutions, colliderRestitutions);
#endif
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].colliderPairCount) return;
    uint index = counters[0].listParity * sim.colliderPairCapacity + q;
    ColliderContact sides = fetchColliderContact(colliderSides, q);
    Arm arm = fetchContactArm(colliderArms, q);
    vec3 place = fetchCentre(sides.mover) + rotate(fetchRotation(sides.mover), arm.r);
    vec3 normal = colliderSurface(sides.collider, place).normal;
    Impulse last = fetchImpulse(lastColliderRestitutions, index);
    vec3 surfaceWay = surfaceMove(sides.collider, place), surfaceVelocity = surfaceWay / sim.substepTime;
    vec3 now = velocityNow(sides.mover, arm.r) - surfaceVelocity;
#if defined(LEDGER)
    float solved = dot(normal, velocitySolved(sides.mover, arm.r) - surfaceVelocity), work = 0.0;
#ifdef MOVING
    // The solver's impulse costs the energy that the mover lost plus what the collider's motion added.
    work = dot(fetchImpulse(colliderImpulses, index).whole / sim.substepTime, surfaceVelocity);
#endif
    colliderLedgers[q] = vec4(gainOf(max(last.normal, 0.0), solved, dot(normal, now), 1.0), work, 0);
#elif defined(SHARE)
    vec3 solver = fetchImpulse(colliderImpulses, index).whole / sim.substepTime;
    colliderRestitutions[index] =
        packImpulse(sharedRestitution(last, normal, solver, restitutionShares(sides.mover)));
#else
    Arrival surface = Arrival(surfaceVelocity, surfaceWay, vec3(0));
    float approach = approachOf(arrivalOf(sides.mover, arm.r), surface, normal);
    float inverseMass = restitutionSplits(sides.mover) * arm.worstInverseMass * sides.fraction;
    float restitution = fetchMass(fetchColliderPair(colliderPairs, index).particle).restitution;
    colliderRestitutions[index] =
        packImpulse(solveRestitution(last, fetchImpulse(colliderImpulses, index).normal, normal, approach, now,
                                     inverseMass, restitution));
#endif
}
