#include "app/scene/matter/scene_fill.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "app/json/fields.h"
#include "app/scene/scene_limits.h"
#include "app/scene/scene_repeat.h"
#include "sim/base/random.h"

namespace knuckle {

namespace {

/// The object whose shape is filled with particles.
struct Filling {
    const SceneEntry& entry;
    const Json& object;
    float spacing;

    void limit(double count) const { limitParticles(entry, count); }
};

std::vector<Vector3f> fillBox(const Filling& filling)
{
    Vector3f size;
    readValue(filling.object["size"], size);
    const Vector3f counts = (size / filling.spacing).array().round().max(1.0f);
    filling.limit(static_cast<double>(counts.x()) * counts.y() * counts.z());
    return boxLattice(counts.cast<int>(), filling.spacing);
}

std::vector<Vector3f> fillRound(const Filling& filling)
{
    const float radius = filling.object["radius"], length = filling.object.value("length", 0.0f);
    const double r = radius / filling.spacing, l = length / filling.spacing;
    filling.limit(std::numbers::pi * r * r * (4.0 / 3.0 * r + l));
    return filling.object["shape"] == "sphere" ? sphereLattice(radius, filling.spacing)
                                               : capsuleLattice(radius, 0.5f * length, filling.spacing);
}

/// A cone on its base, whose middle is the origin.
std::vector<Vector3f> fillCone(const Filling& filling)
{
    const float radius = filling.object["radius"], height = filling.object["height"], spacing = filling.spacing;
    const double r = radius / spacing, h = height / spacing;
    filling.limit(std::numbers::pi * r * r * h / 3.0);
    std::vector<Vector3f> points;
    const int layers = static_cast<int>(std::max(1.0, std::round(h))), reach = static_cast<int>(std::ceil(r));
    for (int y = 0; y < layers; ++y) {
        const float up = (static_cast<float>(y) + 0.5f) * spacing;
        const float wide = std::max(radius * (1.0f - up / height) - 0.5f * spacing, 0.0f) + 1e-4f * spacing;
        for (int z = -reach; z <= reach; ++z)
            for (int x = -reach; x <= reach; ++x) {
                const Vector3f p(static_cast<float>(x) * spacing, up, static_cast<float>(z) * spacing);
                if (std::hypot(p.x(), p.z()) <= wide) points.push_back(p);
            }
    }
    return points;
}

}  // namespace

std::vector<Vector3f> fillRegion(const SceneEntry& object, float spacing)
{
    const Filling filling{object, object.json, spacing};
    const std::string shape = object.json["shape"];
    const auto fill = [&] {
        if (shape == "box") return fillBox(filling);
        if (shape == "cone") return fillCone(filling);
        if (shape == "mesh") return object.actor(spacing).particles;
        return fillRound(filling);
    };
    std::vector<Vector3f> positions = fill();
    if (positions.empty()) object.fail("", fmt::format("holds no particle of diameter {} m; make it larger", spacing));
    filling.limit(static_cast<double>(positions.size()));
    return positions;
}

uint32_t nearestPoint(std::span<const Vector3f> points, const Vector3f& place)
{
    uint32_t nearest = 0;
    for (uint32_t i = 1; i < points.size(); ++i)
        if ((points[i] - place).squaredNorm() < (points[nearest] - place).squaredNorm()) nearest = i;
    return nearest;
}

std::vector<uint32_t> pinnedPoints(const SceneEntry& entry, std::span<const Vector3f> points)
{
    std::vector<uint32_t> pinned;
    const Json& pins = entry.json["pins"];
    for (size_t i = 0; i < pins.size(); ++i) {
        Vector3f place;
        readValue(pins[i], place);
        pinned.push_back(nearestPoint(points, place));
        const Vector3f& p = points[pinned.back()];
        const float distance = (p - place).norm(), most = entry.context.builder.diameter();
        if (distance > most)
            entry.fail(fmt::format("/pins/{}", i),
                       fmt::format("the nearest particle is {:.3g} m away, at [{:.4g}, {:.4g}, {:.4g}], and may be "
                                   "{:.3g} m, a diameter; put the pin there",
                                   distance, p.x(), p.y(), p.z(), most));
    }
    return pinned;
}

void jitterPositions(std::vector<Vector3f>& positions, float amount, uint32_t seed)
{
    if (amount == 0.0f) return;
    std::mt19937 random(seed);
    for (Vector3f& position : positions)
        for (float& side : position) side += amount * (2.0f * uniformFraction(random) - 1.0f);
}

}  // namespace knuckle
