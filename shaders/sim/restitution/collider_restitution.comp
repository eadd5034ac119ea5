// One thread a contact of a particle with a collider: one Jacobi iteration of the impulse that makes it bounce.
#include "sim/common/kernel.glsl"
#include "sim/restitution/restitution.glsl"
#include "sim/common/colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer colliderPairs;    // particle, collider
uniform usamplerBuffer colliderSides;
uniform samplerBuffer colliderArms;
uniform samplerBuffer colliderImpulses;
uniform samplerBuffer masses;            // y: restitution
uniform samplerBuffer lastColliderRestitutions;
BUFFER(vec4, ColliderRestitutions, colliderRestitutions);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].colliderPairCount) return;
    int place = int(counters[0].listParity * sim.colliderPairCapacity + q);
    uvec4 sides = texelFetch(colliderSides, int(q));
    vec4 arm = texelFetch(colliderArms, int(q));
    PointState point = pointState(sides.x, arm.xyz);
    vec3 normal = colliderDistance(sides.y, point.position).xyz;
    float inverseMass = texelFetch(moverRestitutionSplits, int(sides.x)).x * arm.w * unpackUnorm2x16(sides.w).x;
    float restitution = texelFetch(masses, int(texelFetch(colliderPairs, place).x)).y;
    colliderRestitutions[place] = solveRestitution(texelFetch(lastColliderRestitutions, place),
                                         texelFetch(colliderImpulses, place).w, normal,
                                         velocityBefore(sides.x, arm.xyz), point.velocity, inverseMass, restitution);
}
