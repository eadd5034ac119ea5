// One thread a contact of a particle with a collider: one Jacobi iteration of its impulse.
#include "sim/common/kernel.glsl"
#include "sim/common/movers.glsl"
#include "sim/common/colliders.glsl"
#include "sim/contact/contact_impulse.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer colliderSides;
uniform samplerBuffer colliderArms;
uniform samplerBuffer lastColliderImpulses;
uniform samplerBuffer lastColliderMeans;
BUFFER(vec4, ColliderImpulses, colliderImpulses);
BUFFER(float, ColliderMeans, colliderMeans);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].colliderPairCount) return;
    uint place = counters[0].listParity * sim.colliderPairCapacity + q;
    uvec4 sides = texelFetch(colliderSides, int(q));
    vec4 arm = texelFetch(colliderArms, int(q));
    MoverPoint point = moverPoint(sides.x, arm.xyz);
    vec3 start = point.centre + point.arm;
    vec4 surface = colliderDistance(sides.y, start + point.move);
    Contact contact;
    contact.slide = point.move;
    contact.normal = surface.xyz;
    contact.kin = false;
    contact.leaving = dot(point.move, surface.xyz);
    contact.gap = surface.w - 0.5 * sim.diameter;
    contact.startGap = colliderDistance(sides.y, start).w - 0.5 * sim.diameter;
    contact.worstMass = arm.w * point.splits;
    contact.inverseMass = contact.worstMass * unpackUnorm2x16(sides.w).x;
    contact.friction = unpackHalf2x16(sides.z);
    float mean = texelFetch(lastColliderMeans, int(place)).x;
    colliderImpulses[place] = solveContact(contact, texelFetch(lastColliderImpulses, int(place)), mean);
    colliderMeans[place] = mean;
}
