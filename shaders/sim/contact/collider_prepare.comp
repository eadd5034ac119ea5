// One thread a contact of a particle with a collider: sets its data, and gives it its old impulse.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/list_ranges.glsl"
#include "math/spatial.glsl"
#include "sim/common/contacts/collider_point.glsl"
#include "sim/contact/contact_mass.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer searchPositions;
uniform usamplerBuffer colliderPairs;
uniform samplerBuffer lastColliderImpulses;
uniform samplerBuffer lastColliderMeans;
#ifdef ROPES
uniform usamplerBuffer ropeMovers;
#endif
BUFFER(uvec4, ColliderSides, colliderSides);
BUFFER(vec4, ColliderArms, colliderArms);
BUFFER(vec4, ColliderImpulses, colliderImpulses);
BUFFER(float, ColliderMeans, colliderMeans);
BUFFER(Counters, CountersBlock, counters);

/// The index that the contact had before, or NONE.
uint oldIndex(uint parity, uint rank, uint collider)
{
    uvec2 range = listRange(parity, LIST_COLLIDERS, rank, 1u) + parity * sim.colliderPairCapacity;
    for (uint q = range.x; q < range.y; ++q)
        if (fetchColliderPair(colliderPairs, q).collider == collider) return q;
    return NONE;
}

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].colliderPairCount) return;
    uint parity = counters[0].listParity;
    uint index = parity * sim.colliderPairCapacity + q;
    ColliderPair pair = fetchColliderPair(colliderPairs, index);
    ParticleRank own = fetchRank(pair.particle);
    Arm arm = fetchArm(pair.particle);
    vec4 rotation = texelFetch(searchRotations, int(own.mover));
    vec4 position = texelFetch(searchPositions, int(pair.particle));
    vec3 centre = position.xyz - rotate(rotation, arm.r);
    Reference ref = colliderReference(pair.particle, own.mover, pair.collider, position.w, centre, rotation);
    ColliderSurface surface = colliderSurface(pair.collider, centre + rotate(rotation, ref.r));
    vec2 friction = 0.5 * (fetchMass(pair.particle).friction + fetchColliderFriction(pair.collider));
    vec3 r = ref.r - ref.radius * rotate(conjugate(rotation), surface.normal);
    SideMass mass = sideMass(own.mover, arm, r, surface.normal);
    bool ofRope = false;
#ifdef ROPES
    ofRope = texelFetch(ropeMovers, int(own.mover)).x != 0u;
#endif
    colliderSides[q] = packColliderContact(ColliderContact(own.mover, pair.collider, friction, mass.fraction, ofRope));
    colliderArms[q] = packArm(Arm(r, mass.worst));
    uint old = oldIndex(parity ^ 1u, own.rank, pair.collider);
    Impulse impulse = old == NONE ? Impulse(vec3(0), 0.0) : fetchImpulse(lastColliderImpulses, old);
    if (surface.distance < ref.radius && impulse.normal <= 0.0) impulse.normal = ABOUT_TO_ACT;
    colliderImpulses[index] = packImpulse(impulse);
    colliderMeans[index] = old == NONE ? 0.0 : texelFetch(lastColliderMeans, int(old)).x;
}
