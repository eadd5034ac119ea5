// One thread a contact of a particle with a collider: one Jacobi iteration of its impulse.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/contacts/collider_moves.glsl"
#include "sim/common/contacts/collider_point.glsl"
#include "sim/contact/contact_impulse.glsl"
#include "sim/contact/contact_place.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer colliderPairs;
uniform usamplerBuffer colliderSides;
uniform samplerBuffer lastColliderArms;
uniform samplerBuffer lastColliderImpulses;
BUFFER(vec4, ColliderArms, colliderArms);
BUFFER(vec4, ColliderImpulses, colliderImpulses);
BUFFER(float, ColliderMeans, colliderMeans);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].colliderPairCount) return;
    uint index = counters[0].listParity * sim.colliderPairCapacity + q;
    uint particle = fetchColliderPair(colliderPairs, index).particle;
    ColliderContact sides = fetchColliderContact(colliderSides, q);
    Impulse last = fetchImpulse(lastColliderImpulses, index);
    Arm arm = fetchContactArm(lastColliderArms, q);
    vec4 rotation = quaternionProduct(fetchRotationDelta(sides.mover), fetchRotation(sides.mover));
    float excess = radiusExcess(sides.mover);
    Reference ref =
        colliderReference(particle, sides.mover, sides.collider, excess, fetchCentre(sides.mover), rotation);
    MoverPoint point = moverPoint(sides.mover, ref.r);
    vec3 start = point.centre + point.arm;
    ColliderSurface surface = colliderSurface(sides.collider, start + point.move);
    vec3 offset = -ref.radius * surface.normal;
    vec3 surfaceWay = surfaceMove(sides.collider, start + point.move + offset);
    Contact contact;
    contact.touch = 2.0 * particleRadius(excess);
    contact.normal = surface.normal;
    contact.sameAssembly = false;
    setKind(contact, vec2(excess));
    contact.stickSpeed = STICK_SPEED;
    contact.leaving = max(dot(point.move, surface.normal), -dot(surfaceWay, surface.normal));
    contact.gap = surface.distance - ref.radius;
    contact.startGap = colliderSurface(sides.collider, takenAlong(sides.collider, start)).distance - ref.radius;
    contact.worstInverseMass = arm.worstInverseMass * point.splits;
    contact.inverseMass = contact.worstInverseMass * sides.fraction;
    contact.friction = sides.friction;
    if (ref.round) {
        vec3 before = rotate(rotation, arm.r - ref.r) - offset;
        offset += rollingOffset(fetchRound(sides.mover).rolling * ref.radius, before, point.move - surfaceWay,
                                surface.normal, last.normal, contact.worstInverseMass);
    }
    arm.r = armAt(sides.mover, ref.r, offset);
    contact.slide = moverPoint(sides.mover, arm.r).move - surfaceWay;
    float mean = colliderMeans[index];   // no texture of it: sixteen are needed beside it
    colliderImpulses[index] = packImpulse(solveContact(contact, last, mean));
    colliderMeans[index] = mean;
    colliderArms[q] = packArm(arm);
}
