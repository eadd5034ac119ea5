#include <algorithm>
#include <cmath>

#include "sim/world/builder/builder.h"

namespace knuckle {

namespace {

/// Points of the lattice through the origin, within +-reach cells an axis, for which `inside` holds.
template <typename Inside>
std::vector<Vector3f> latticeWhere(const Eigen::Vector3i& reach, float diameter, Inside inside)
{
    std::vector<Vector3f> points;
    for (int z = -reach.z(); z <= reach.z(); ++z)
        for (int y = -reach.y(); y <= reach.y(); ++y)
            for (int x = -reach.x(); x <= reach.x(); ++x) {
                const Vector3f p = diameter * Eigen::Vector3i(x, y, z).cast<float>();
                if (inside(p)) points.push_back(p);
            }
    return points;
}

int cells(float length, float diameter)
{
    return static_cast<int>(std::ceil(length / diameter));
}

}  // namespace

std::vector<Vector3f> boxLattice(const Eigen::Vector3i& counts, float diameter)
{
    std::vector<Vector3f> points;
    const Vector3f half = 0.5f * (counts.cast<float>() - Vector3f::Ones());
    for (int z = 0; z < counts.z(); ++z)
        for (int y = 0; y < counts.y(); ++y)
            for (int x = 0; x < counts.x(); ++x)
                points.push_back(diameter * (Eigen::Vector3i(x, y, z).cast<float>() - half));
    return points;
}

std::vector<Vector3f> sphereLattice(float radius, float diameter)
{
    // A particle extends half a diameter beyond its centre; 1e-4 more keeps the lattice symmetric under rounding.
    const float reach = radius - 0.5f * diameter + 1e-4f * diameter;
    const int n = cells(radius, diameter);
    return latticeWhere({n, n, n}, diameter, [&](const Vector3f& p) { return p.norm() <= std::max(reach, 0.0f); });
}

std::vector<Vector3f> capsuleLattice(float radius, float halfHeight, float diameter)
{
    const float reach = std::max(radius - 0.5f * diameter + 1e-4f * diameter, 0.0f);
    const int n = cells(radius, diameter);
    return latticeWhere({n, cells(radius + halfHeight, diameter), n}, diameter, [&](const Vector3f& p) {
        const Vector3f onAxis(0, std::clamp(p.y(), -halfHeight, halfHeight), 0);
        return (p - onAxis).norm() <= reach;
    });
}

}  // namespace knuckle
