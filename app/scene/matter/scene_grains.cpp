#include "app/scene/matter/scene_grains.h"

#include <fmt/format.h>

#include <cmath>

#include "app/scene/matter/scene_fill.h"
#include "app/scene/scene_draw.h"
#include "sim/world/matter/grain.h"

namespace knuckle {

namespace {

/// Moves every other layer by a quarter of the spacing: balls directly on each other, or in the hollows of the layer
/// below, would hold without friction.
void shiftLayers(std::vector<Vector3f>& positions, float spacing)
{
    for (Vector3f& position : positions) {
        const bool odd = std::lround(position.y() / spacing - 0.25f) % 2 != 0;
        const float shift = odd ? 0.125f * spacing : -0.125f * spacing;
        position += Vector3f(shift, 0, shift);
    }
}

}  // namespace

void addGrains(const ObjectEntry& entry)
{
    WorldBuilder& builder = entry.context.builder;
    const Json& object = entry.json;
    float spacing = object["spacing"];
    if (spacing == 0.0f) spacing = builder.diameter();
    if (spacing < (1.0f - 1e-5f) * builder.diameter())
        entry.fail(
            "/spacing",
            fmt::format("{} m is below the diameter, {} m, so that grains would overlap; raise it, lower /diameter, "
                        "or give 0 for one diameter",
                        spacing, builder.diameter()));
    std::vector<Vector3f> lattice = fillRegion(entry, spacing);
    const float jitter = object["jitter"].get<float>() * builder.diameter();
    if (jitter > 0.0f) shiftLayers(lattice, spacing);
    uint32_t seed = object["seed"];
    const bool impulses = builder.world().settings.solver == SolverKind::Impulse;  // the paper's has one size
    const bool drawn = isDrawnAs(entry, DrawnAs::Shape, "a grain");
    Particle grain;
    grain.velocity = entry.velocity;
    grain.material = entry.material;
    grain.mass = builder.particleMass(entry.material);
    for (size_t copy = 0; copy < entry.poses.size(); ++copy) {
        const uint32_t first = builder.particleCount();
        std::vector<Vector3f> positions = lattice;
        jitterPositions(positions, jitter, seed++);
        for (const Vector3f& position : positions) {
            if (impulses) grain.scale = grainScale(builder.particleCount() - first);
            grain.position = grain.restPosition = entry.poses[copy].apply(position);
            builder.addLooseParticle(grain);
        }
        if (drawn) builder.drawGrains(first);
        builder.nameLoose(entry.copyName(copy), first);
    }
}

}  // namespace knuckle
