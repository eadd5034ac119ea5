#include "sim/rig/mesh/solid.h"

#include "sim/base/errors.h"

namespace knuckle {

using Eigen::Vector3f;

Solid::Solid(std::span<const Vector3f> vertices, std::span<const Triangle> triangles)
    : vertices_(vertices), triangles_(triangles), tree_(vertices, triangles)
{
    if (triangles.empty()) throw InputError("the model has no triangles to fill with particles");
    for (const Triangle& triangle : triangles)
        for (const uint32_t v : triangle) bounds_.extend(vertices[v]);
    if (!(bounds_.sizes().maxCoeff() > 0.0f))
        throw InputError("the model has no size: all of its vertices are at one point");
}

float Solid::signedDistance(const Vector3f& point) const
{
    const float distance = tree_.nearest(point).distance;
    return inside(point) ? -distance : distance;
}

}  // namespace knuckle
