// Contents of the buffers of contacts. The search sets a contact's data (contact_prepare, collider_prepare); each
// iteration only changes its impulse.
#include "sim/common/contacts/flat_faces.glsl"
#include "sim/common/contacts/impulses.glsl"
#include "sim/common/particles.glsl"

#define FRACTION_LEVELS 8191.0          // 13 bits

/// The two particles of a contact, as in `pairs`.
struct Pair {
    uint first, second;
};

Pair fetchPair(usamplerBuffer pairs, uint index)
{
    uvec2 t = texelFetch(pairs, int(index)).xy;
    return Pair(t.x, t.y);
}

/// A contact of a particle with a collider, as in `colliderPairs`.
struct ColliderPair {
    uint particle, collider;
};

ColliderPair fetchColliderPair(usamplerBuffer colliderPairs, uint index)
{
    uvec2 t = texelFetch(colliderPairs, int(index)).xy;
    return ColliderPair(t.x, t.y);
}

/// The two sides of a contact between particles, as in `pairSides`.
struct ContactSides {
    uvec2 movers;
    ExitDirection exit;
    vec2 friction;       // static, kinetic
    vec2 fractions;      // of each side's worst inverse mass, in the direction of the normal: 0 ... 1
    uint hidden;         // axes (sim/common/contacts/flat_faces.glsl), three bits for each side
};

uvec4 packContactSides(ContactSides sides)
{
    uvec2 levels = uvec2(sides.fractions * FRACTION_LEVELS + 0.5);
    return uvec4(sides.movers | packExit(sides.exit), packHalf2x16(sides.friction),
                 levels.x | levels.y << 13 | sides.hidden << 26);
}

ContactSides fetchContactSides(usamplerBuffer pairSides, uint q)
{
    uvec4 t = texelFetch(pairSides, int(q));
    return ContactSides(t.xy & MOVER_MASK, unpackExit(t.xy), unpackHalf2x16(t.z),
                     vec2(t.w & 0x1fffu, t.w >> 13 & 0x1fffu) / FRACTION_LEVELS, t.w >> 26);
}

/// The sides of a contact with a collider, as in `colliderSides`.
struct ColliderContact {
    uint mover, collider;
    vec2 friction;       // static, kinetic
    float fraction;      // of the mover's worst inverse mass, in the direction of the normal: 0 ... 1
    bool ofRope;         // it is solved with the mover's rope (sim/strand/rope_contact.glsl)
};

uvec4 packColliderContact(ColliderContact sides)
{
    return uvec4(sides.mover, sides.collider, packHalf2x16(sides.friction),
                 packUnorm2x16(vec2(sides.fraction, sides.ofRope ? 0 : 1)));
}

ColliderContact fetchColliderContact(usamplerBuffer colliderSides, uint q)
{
    uvec4 t = texelFetch(colliderSides, int(q));
    vec2 rest = unpackUnorm2x16(t.w);
    return ColliderContact(t.x, t.y, unpackHalf2x16(t.z), rest.x, rest.y == 0.0);
}

/// Where pairArms has the arms of a pair's two particles.
uint firstArm(uint q) { return 2u * q; }
uint secondArm(uint q) { return 2u * q + 1u; }

/// An arm of `pairArms` or `colliderArms`.
Arm fetchContactArm(samplerBuffer arms, uint index)
{
    return armOf(texelFetch(arms, int(index)));
}

vec4 packArm(Arm arm)
{
    return vec4(arm.r, arm.worstInverseMass);
}
