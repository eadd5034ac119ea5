#include "sim/world/matter/surface.h"

#include <algorithm>
#include <cmath>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float TIE = 0.01f;

/// SurfaceDistance::ends of a particle at these distances from the outermost ones on each side [m].
uint32_t latticeEnds(const Vector3f& fromLow, const Vector3f& toHigh, float diameter)
{
    uint32_t ends = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (fromLow[axis] < 0.5f * diameter) ends |= 1u << 2 * axis;
        if (toHigh[axis] < 0.5f * diameter) ends |= 2u << 2 * axis;
    }
    return ends;
}

}  // namespace

SurfaceDistance boxSurface(const Vector3f& point, const Vector3f& halfExtents)
{
    const Vector3f beyond = point.cwiseAbs() - halfExtents;
    const float nearest = beyond.maxCoeff(), tie = TIE * halfExtents.minCoeff();
    SurfaceDistance surface{nearest, {0, 0, 0}};
    for (int axis = 0; axis < 3; ++axis) {
        if (beyond[axis] < nearest - tie || std::abs(point[axis]) <= tie) continue;
        surface.outward[axis] = point[axis] > 0.0f ? 1.0f : -1.0f;
    }
    surface.outward.normalize();  // leaves zero as it is
    return surface;
}

SurfaceDistance capsuleSurface(const Vector3f& point, float radius, float halfHeight)
{
    const Vector3f fromAxis = point - Vector3f(0, std::clamp(point.y(), -halfHeight, halfHeight), 0);
    const float far = fromAxis.norm();
    const bool onAxis = far <= TIE * radius;
    return {far - radius, onAxis ? Vector3f(Vector3f::Zero()) : Vector3f(fromAxis / far)};
}

std::vector<SurfaceDistance> latticeSurface(std::span<const Vector3f> positions, float diameter)
{
    if (positions.empty()) return {};
    Vector3f low = positions.front(), high = low;
    for (const Vector3f& position : positions) {
        low = low.cwiseMin(position);
        high = high.cwiseMax(position);
    }
    const Eigen::Vector3d counts = ((high - low) / diameter).cast<double>().array().round() + 1.0;
    if (counts.prod() != static_cast<double>(positions.size())) return {};
    const Vector3f spacing = (high - low).cwiseQuotient((counts.array() - 1.0).max(1.0).matrix().cast<float>());
    for (const Vector3f& position : positions)
        for (int axis = 0; axis < 3; ++axis) {
            const float off = std::fmod(position[axis] - low[axis] + 0.5f * spacing[axis], spacing[axis]);
            if (spacing[axis] > TIE * diameter && std::abs(off - 0.5f * spacing[axis]) > TIE * diameter) return {};
        }
    const Vector3f centre = 0.5f * (low + high), half = 0.5f * (high - low).array() + 0.5f * diameter;
    std::vector<SurfaceDistance> surfaces;
    for (const Vector3f& position : positions) {
        surfaces.push_back(boxSurface(position - centre, half));
        surfaces.back().ends = latticeEnds(position - low, high - position, diameter);
    }
    return surfaces;
}

}  // namespace knuckle
