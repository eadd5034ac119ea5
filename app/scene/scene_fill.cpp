#include "app/scene/scene_fill.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "app/json/fields.h"
#include "app/scene/scene_file.h"

namespace knuckle {

namespace {

/// The object whose shape is to be filled with particles.
struct Region {
    SceneContext& context;
    const Json& object;
    const std::string& pointer;
    float spacing;

    void limit(double count) const { limitParticles(context, object, pointer, count); }
};

std::vector<Vector3f> fillBox(const Region& region)
{
    Vector3f size;
    readValue(region.object["size"], size);
    const Vector3f counts = (size / region.spacing).array().round().max(1.0f);
    region.limit(static_cast<double>(counts.x()) * counts.y() * counts.z());
    return boxLattice(counts.cast<int>(), region.spacing);
}

std::vector<Vector3f> fillRound(const Region& region)
{
    const float radius = region.object["radius"], length = region.object.value("length", 0.0f);
    const double r = radius / region.spacing, l = length / region.spacing;
    region.limit(std::numbers::pi * r * r * (4.0 / 3.0 * r + l));
    return region.object["shape"] == "sphere" ? sphereLattice(radius, region.spacing)
                                              : capsuleLattice(radius, 0.5f * length, region.spacing);
}

/// A cone that stands on its base, whose middle is the origin.
std::vector<Vector3f> fillCone(const Region& region)
{
    const float radius = region.object["radius"], height = region.object["height"], spacing = region.spacing;
    const double r = radius / spacing, h = height / spacing;
    region.limit(std::numbers::pi * r * r * h / 3.0);
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

void limitTotal(const SceneContext& context, const std::string& pointer, double count, const char* remedy)
{
    const WorldBuilder& builder = context.builder;
    const double total = count + builder.particleCount() + builder.fluidCount() + builder.world().pooledCount();
    if (total <= static_cast<double>(MAX_PARTICLES)) return;
    const std::string number = total < 1e15 ? fmt::format("{:.0f}", total) : fmt::format("{:.1e}", total);
    failAt(context.path, pointer,
           fmt::format("brings the scene to {} particles, the limit is {}; {}", number, MAX_PARTICLES, remedy));
}

void limitParticles(const SceneContext& context, const Json& object, const std::string& pointer, double count)
{
    limitTotal(context, pointer, count * static_cast<double>(copyCount(object)),
               "raise /diameter, or make it smaller or fewer");
}

std::vector<Vector3f> fillRegion(SceneContext& context, const Json& object, const std::string& pointer, float spacing)
{
    const Region region{context, object, pointer, spacing};
    const std::string shape = object["shape"];
    const auto fill = [&] {
        if (shape == "box") return fillBox(region);
        if (shape == "cone") return fillCone(region);
        if (shape == "mesh") return findActor(context, object, pointer, spacing).particles;
        return fillRound(region);
    };
    std::vector<Vector3f> positions = fill();
    if (positions.empty())
        failAt(context.path, pointer, fmt::format("holds no particle of diameter {} m; make it larger", spacing));
    region.limit(static_cast<double>(positions.size()));
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
