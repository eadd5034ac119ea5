// One thread a contact of a particle with a collider: one Jacobi iteration of its impulse.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/stacks.glsl"
#include "sim/contact/collider_now.glsl"
#include "sim/contact/contact_impulse.glsl"
#include "sim/contact/contact_place.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer colliderPairs;
uniform usamplerBuffer colliderSides;
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
    if (inStack(sides.mover) || sides.ofRope) return;
    float mean = colliderMeans[index];   // no texture of it and of the arms: sixteen are needed beside them
    Impulse last = fetchImpulse(lastColliderImpulses, index);
    Arm arm = armOf(colliderArms[q]);
    vec4 rotation = quaternionProduct(fetchRotationDelta(sides.mover), fetchRotation(sides.mover));
    float excess = radiusExcess(sides.mover);
    ColliderNow now = colliderNow(particle, sides.mover, sides.collider, excess, rotation);
    Contact contact;
    contact.touch = 2.0 * particleRadius(excess);
    contact.normal = now.normal;
    contact.sameAssembly = false;
    setKind(contact, vec2(excess));
    contact.stickSpeed = STICK_SPEED;
    contact.leaving = max(dot(now.point.move, now.normal), -dot(now.surfaceWay, now.normal));
    contact.gap = now.gap;
    contact.startGap = now.startGap;
    contact.worstInverseMass = arm.worstInverseMass * now.point.splits;
    contact.inverseMass = contact.worstInverseMass * sides.fraction;
    contact.friction = sides.friction;
    vec3 offset = now.offset;
    if (now.ref.round) {
        vec3 before = rotate(rotation, arm.r - now.ref.r) - offset;
        offset += rollingOffset(fetchRound(sides.mover).rolling * now.ref.radius, before,
                                now.point.move - now.surfaceWay, now.normal, last.normal, contact.worstInverseMass);
    }
    arm.r = armAt(sides.mover, now.ref.r, offset);
    contact.slide = moverPoint(sides.mover, arm.r).move - now.surfaceWay;
    colliderImpulses[index] = packImpulse(solveContact(contact, last, mean));
    colliderMeans[index] = mean;
    colliderArms[q] = packArm(arm);
}
