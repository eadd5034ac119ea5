#include "sim/world/matter/drawn_matter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "sim/world/world.h"

namespace knuckle {

namespace {

/// Resistance of the fit to slopes that its particles do not determine, in squares of the reach.
constexpr float RESISTANCE = 1e-3f;

HullVertex boundVertex(const Vector3f& place, std::span<const Vector3f> particles, float reach)
{
    const size_t count = std::min(HULL_LINKS, particles.size()), sorted = std::min(count + 1, particles.size());
    std::vector<uint32_t> order(particles.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto distance = [&](uint32_t i) { return (particles[i] - place).squaredNorm(); };
    std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(sorted), {}, distance);
    const float nearest = std::sqrt(distance(order[0]));
    const auto weightOf = [&](uint32_t i) {
        const float far = (std::sqrt(distance(i)) - nearest) / reach;
        return std::exp(-far * far);
    };
    // Nothing at the first particle that is left out, so that the surface has no step where another one is.
    const float least = sorted > count ? (1.0f - 1e-3f) * weightOf(order[count]) : 0.0f;
    // Fit of a plane in four dimensions about the mean: weight_i = w_i (1 + (x_i - mean) M^-1 (place - mean)).
    std::vector<float> weights;
    float sum = 0.0f;
    Vector3f mean = Vector3f::Zero();
    for (size_t k = 0; k < count; ++k) {
        weights.push_back(weightOf(order[k]) - least);
        sum += weights[k];
        mean += weights[k] * particles[order[k]];
    }
    mean /= sum;
    Eigen::Matrix3f moments = RESISTANCE * reach * reach * sum * Eigen::Matrix3f::Identity();
    for (size_t k = 0; k < count; ++k) {
        const Vector3f arm = particles[order[k]] - mean;
        moments += weights[k] * arm * arm.transpose();
    }
    const Vector3f slope = moments.ldlt().solve(place - mean);
    HullVertex vertex;
    for (size_t k = 0; k < count; ++k) {
        vertex.particles[k] = order[k];
        vertex.weights[k] = weights[k] * (1.0f / sum + slope.dot(particles[order[k]] - mean));
    }
    return vertex;
}

void require(bool holds, const char* what)
{
    if (!holds) throw std::logic_error(std::string("what is drawn of matter ") + what);
}

void requireTriangles(const std::vector<std::array<uint32_t, 3>>& triangles, size_t vertices)
{
    for (const auto& triangle : triangles)
        require(*std::ranges::max_element(triangle) < vertices, "has a triangle with a corner too many");
}

}  // namespace

std::vector<HullVertex> bindHull(std::span<const Vector3f> places, std::span<const Vector3f> particles, float reach)
{
    std::vector<HullVertex> vertices;
    for (const Vector3f& place : places) vertices.push_back(boundVertex(place, particles, reach));
    return vertices;
}

void validateDrawnMatter(const World& world)
{
    const size_t count = world.particles.size();
    for (const ClothSurface& sheet : world.drawn.cloth) {
        for (const uint32_t node : sheet.nodes) require(node < count, "has a particle that is not there");
        requireTriangles(sheet.triangles, sheet.nodes.size());
        if (sheet.columns == 0 && sheet.rows == 0) continue;
        require(sheet.columns >= 2 && sheet.rows >= 2, "has a sheet without cells");
        require(sheet.nodes.size() == size_t{sheet.columns} * sheet.rows, "has a sheet of another size");
        require(sheet.triangles.size() == size_t{2} * (sheet.columns - 1) * (sheet.rows - 1), "has other triangles");
    }
    for (const uint32_t strand : world.drawn.ropes)
        require(strand < world.strands.size(), "has a rope that is not there");
    for (const SoftSurface& surface : world.drawn.soft) {
        require(surface.softBody < world.softBodies.size() && surface.hull, "has a soft body that is not there");
        requireTriangles(surface.hull->triangles, surface.hull->vertices.size());
        for (const HullVertex& vertex : surface.hull->vertices)
            require(*std::ranges::max_element(vertex.particles) < world.softBodies[surface.softBody].particleCount,
                    "has a soft body without one of its particles");
    }
    for (const ParticleRange& range : world.drawn.grains)
        require(range.first <= range.end && range.end <= count, "has a grain that is not there");
}

}  // namespace knuckle
