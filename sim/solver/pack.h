#pragma once

#include "shared/gpu_types.h"
#include "sim/world/world.h"

namespace knuckle {

/// As kernels read it.
inline gpu::vec4 pack(const Vector3f& v, float w)
{
    return {v.x(), v.y(), v.z(), w};
}

inline gpu::vec4 pack(const Quaternionf& q)
{
    return pack(q.vec(), q.w());
}

/// Of the first three values.
inline Vector3f vectorOf(const gpu::vec4& v)
{
    return {v.x, v.y, v.z};
}

/// Half extents of a box, else radius and half height [m].
inline Vector3f sizeOf(const Region& region)
{
    if (region.shape == ColliderShape::Box) return region.halfExtents;
    return {region.radius, region.halfHeight, 0};
}

}  // namespace knuckle
