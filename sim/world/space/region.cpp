#include "sim/world/space/region.h"

#include <algorithm>
#include <stdexcept>

namespace knuckle {

using Eigen::Vector3f;

float regionDistance(const Region& region, const Vector3f& point)
{
    const Vector3f p = region.orientation.conjugate() * (point - region.position);
    switch (region.shape) {
        case ColliderShape::Plane: return p.y();
        case ColliderShape::Box: {
            const Vector3f q = p.cwiseAbs() - region.halfExtents;
            return q.cwiseMax(0.0f).norm() + std::min(q.maxCoeff(), 0.0f);
        }
        case ColliderShape::Sphere: return p.norm() - region.radius;
        case ColliderShape::Capsule: {
            const float along = std::clamp(p.y(), -region.halfHeight, region.halfHeight);
            return (p - Vector3f(0, along, 0)).norm() - region.radius;
        }
        default: throw std::logic_error("the distance to a mesh needs its grid");
    }
}

}  // namespace knuckle
