// One thread a contact of a particle with a collider: one Jacobi iteration of the impulse that makes it bounce.
#include "sim/common/kernel.glsl"
#include "sim/restitution/restitution.glsl"
#include "sim/common/contacts/colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer colliderPairs;
uniform usamplerBuffer colliderSides;
uniform samplerBuffer colliderArms;
uniform samplerBuffer colliderImpulses;
uniform samplerBuffer lastColliderRestitutions;
BUFFER(vec4, ColliderRestitutions, colliderRestitutions);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].colliderPairCount) return;
    uint index = counters[0].listParity * sim.colliderPairCapacity + q;
    ColliderContact sides = fetchColliderContact(colliderSides, q);
    Arm arm = fetchContactArm(colliderArms, q);
    PointState point = pointState(sides.mover, arm.r);
    vec3 normal = colliderSurface(sides.collider, point.position).normal;
    float inverseMass = restitutionSplits(sides.mover) * arm.worstInverseMass * sides.fraction;
    float restitution = fetchMass(fetchColliderPair(colliderPairs, index).particle).restitution;
    colliderRestitutions[index] = packImpulse(
        solveRestitution(fetchImpulse(lastColliderRestitutions, index), fetchImpulse(colliderImpulses, index).normal,
                         normal, velocityBefore(sides.mover, arm.r), point.velocity, inverseMass, restitution));
}
