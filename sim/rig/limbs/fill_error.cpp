#include "sim/rig/limbs/fill_error.h"

#include <cmath>
#include <limits>

#include "sim/world/space/cells.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float FINEST = 1.0f / 60.0f;  // of the longest side: spacing of the lattice that measures the volume
constexpr float FARTHEST = 2.0f;        // d: a surface further away counts as this far

double volumeOf(const Solid& solid, float spacing)
{
    double count = 0.0;
    const Eigen::AlignedBox3f& box = solid.bounds();
    for (float x = box.min().x(); x <= box.max().x(); x += spacing)
        for (float y = box.min().y(); y <= box.max().y(); y += spacing)
            for (float z = box.min().z(); z <= box.max().z(); z += spacing) count += solid.inside({x, y, z});
    return count * std::pow(double{spacing}, 3);
}

}  // namespace

FillError fillError(const Actor& actor, const Solid& solid)
{
    const float d = actor.diameter;
    Cells cells(FARTHEST * d);
    for (uint32_t p = 0; p < actor.particles.size(); ++p) cells.add(actor.particles[p], p);
    double sum = 0.0, count = 0.0;
    solid.forEachSample(
        0.5f * d, std::numeric_limits<double>::infinity(), [&](const Vector3f& point, const Vector3f&, uint32_t) {
            float nearest = FARTHEST * d;
            cells.forEachAround(point,
                                [&](uint32_t p) { nearest = std::min(nearest, (actor.particles[p] - point).norm()); });
            sum += std::pow(double{nearest} / d - 0.5, 2);
            count += 1.0;
        });
    const float spacing = std::max(0.5f * d, FINEST * solid.bounds().sizes().maxCoeff());
    const double cubes = static_cast<double>(actor.particles.size()) * std::pow(double{d}, 3);
    return {cubes / volumeOf(solid, spacing), count > 0.0 ? std::sqrt(sum / count) : 0.0};
}

}  // namespace knuckle
