// Static colliders near a slot, by the bits that fluid_collider_near has set.
#include "sim/common/contacts/colliders.glsl"

uniform usamplerBuffer slotColliders;    // bit k for colliders k, k + 32, ...

/// Visits each collider near a slot: `for (NearColliders n = nearColliders(k); nextCollider(n);) ... n.index`.
struct NearColliders {
    uint bits;    // of the slot
    uint left;    // those not yet visited in this block
    uint block;   // first of 32 colliders
    uint index;   // the collider
};

NearColliders nearColliders(uint slot)
{
    uint bits = texelFetch(slotColliders, int(slot)).x;
    return NearColliders(bits, bits, 0u, 0u);
}

bool nextCollider(inout NearColliders near)
{
    if (near.left == 0u && near.bits != 0u) {
        near.block += 32u;
        near.left = near.bits;
    }
    near.index = near.block + uint(findLSB(near.left));
    near.left &= near.left - 1u;
    return near.bits != 0u && near.index < sim.colliderCount;
}

/// Pushes x out of the colliders, at least a quarter of the rest distance away from them.
vec3 outside(uint k, vec3 x)
{
    for (NearColliders near = nearColliders(k); nextCollider(near);) {
        ColliderSurface wall = colliderSurface(near.index, x);
        x += max(0.25 * sim.fluidSpacing - wall.distance, 0.0) * wall.normal;
    }
    return x;
}
