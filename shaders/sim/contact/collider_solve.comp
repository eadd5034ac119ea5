// One thread a contact of a particle with a collider: one Jacobi iteration of its impulse.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/contacts/colliders.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/contacts/touch.glsl"
#include "sim/contact/contact_impulse.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer colliderPairs;
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
    uint index = counters[0].listParity * sim.colliderPairCapacity + q;
    float radius = particleRadius(fetchColliderPair(colliderPairs, index).particle);
    ColliderContact sides = fetchColliderContact(colliderSides, q);
    Arm arm = fetchContactArm(colliderArms, q);
    MoverPoint point = moverPoint(sides.mover, arm.r);
    vec3 start = point.centre + point.arm;
    ColliderSurface surface = colliderSurface(sides.collider, start + point.move);
    Contact contact;
    contact.touch = 2.0 * radius;
    contact.slide = point.move;
    contact.normal = surface.normal;
    contact.sameAssembly = false;
    contact.leaving = dot(point.move, surface.normal);
    contact.gap = surface.distance - radius;
    contact.startGap = colliderSurface(sides.collider, start).distance - radius;
    contact.worstInverseMass = arm.worstInverseMass * point.splits;
    contact.inverseMass = contact.worstInverseMass * sides.fraction;
    contact.friction = sides.friction;
    float mean = texelFetch(lastColliderMeans, int(index)).x;
    colliderImpulses[index] = packImpulse(solveContact(contact, fetchImpulse(lastColliderImpulses, index), mean));
    colliderMeans[index] = mean;
}
