#include "sim/world/matter/emitter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace knuckle {

namespace {

using Eigen::Vector3f;

/// Layers are wider than the nozzle by this factor. At exactly the rest density, rounding alone would cause pressure.
constexpr float WIDER = 1.01f;

/// Distance between layers: the volume of a layer's particles over the nozzle's area.
float layersApart(size_t count, float area, float spacing)
{
    return static_cast<float>(count) * spacing * spacing * spacing / area;
}

/// Points of the square lattice of pitch 1, `offset` beside the origin, by their distance from it.
std::vector<Vector3f> latticeByDistance(float offset, int reach)
{
    std::vector<Vector3f> points;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x)
            points.emplace_back(static_cast<float>(x) + offset, static_cast<float>(y) + offset, 0.0f);
    std::stable_sort(points.begin(), points.end(),
                     [](const Vector3f& a, const Vector3f& b) { return a.squaredNorm() < b.squaredNorm(); });
    return points;
}

/// The first points, about `wanted` of them, ending with a complete ring of points at one distance from the origin.
std::vector<Vector3f> wholeRings(std::vector<Vector3f> points, double wanted)
{
    size_t best = 0;
    const auto miss = [&](size_t count) { return std::abs(static_cast<double>(count) - wanted); };
    for (size_t k = 1; k < points.size(); ++k)
        if (points[k].norm() > points[k - 1].norm() + 1e-3f && (best == 0 || miss(k) < miss(best))) best = k;
    points.resize(best);
    return points;
}

}  // namespace

Nozzle discNozzle(float radius, float spacing)
{
    const float area = std::numbers::pi_v<float> * radius * radius;
    const double wanted = area / (spacing * spacing);
    Nozzle nozzle;
    if (wanted < 0.5) return nozzle;
    const int reach = static_cast<int>(std::ceil(radius / spacing)) + 2;
    nozzle.points = wholeRings(latticeByDistance(0.0f, reach), wanted);
    std::vector<Vector3f> between = wholeRings(latticeByDistance(0.5f, reach), wanted);
    const auto miss = [&](const auto& points) { return std::abs(static_cast<double>(points.size()) - wanted); };
    if (miss(between) < miss(nozzle.points)) nozzle.points = std::move(between);
    nozzle.pitch = WIDER * std::sqrt(area / static_cast<float>(nozzle.points.size()));
    for (Vector3f& point : nozzle.points) point *= nozzle.pitch;
    nozzle.layerSpacing = layersApart(nozzle.points.size(), area, spacing);
    return nozzle;
}

Nozzle rectangleNozzle(float width, float height, float spacing)
{
    Nozzle nozzle;
    if (std::min(width, height) < 0.5f * spacing) return nozzle;
    const float columns = std::max(std::round(width / spacing), 1.0f);
    const float rows = std::max(std::round(height / spacing), 1.0f);
    for (int y = 0; y < static_cast<int>(rows); ++y)
        for (int x = 0; x < static_cast<int>(columns); ++x)
            nozzle.points.emplace_back(WIDER * ((static_cast<float>(x) + 0.5f) * width / columns - 0.5f * width),
                                       WIDER * ((static_cast<float>(y) + 0.5f) * height / rows - 0.5f * height), 0.0f);
    nozzle.pitch = WIDER * std::min(width / columns, height / rows);
    nozzle.layerSpacing = layersApart(nozzle.points.size(), width * height, spacing);
    return nozzle;
}

Nozzle placed(Nozzle nozzle, const Vector3f& position, const Vector3f& direction)
{
    Vector3f level = Vector3f::UnitY().cross(direction);
    level = level.norm() > 1e-4f ? Vector3f(level.normalized()) : Vector3f::UnitX();
    const Vector3f across = direction.cross(level);
    for (Vector3f& point : nozzle.points) point = position + point.x() * level + point.y() * across;
    return nozzle;
}

uint64_t Emitter::layersUntil(double t) const
{
    const double end = std::min(t, stop);
    return end < start ? 0 : static_cast<uint64_t>(std::floor((end - start) / interval())) + 1;
}

}  // namespace knuckle
