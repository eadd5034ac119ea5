// Static colliders near a slot.
#include "sim/common/colliders.glsl"

uniform usamplerBuffer slotColliders;    // bits: bit k for colliders k, k + 32, ...

#define NO_COLLIDER 0xffffffffu

/// Calls for each collider near a slot: `for (NearColliders n = nearColliders(k); nextCollider(n);) ... n.index`.
struct NearColliders {
    uint bits, left, block, index;
};

NearColliders nearColliders(uint slot)
{
    uint bits = texelFetch(slotColliders, int(slot)).x;
    return NearColliders(bits, bits, 0u, NO_COLLIDER);
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
