#include <fmt/format.h>

#include <cmath>

#include "app/scene_fill.h"
#include "app/scene_parts.h"

namespace knuckle {

void addGrains(SceneContext& context, const Json& object, const std::string& pointer, const LooseKind& kind,
               const std::vector<Pose>& poses)
{
    WorldBuilder& builder = context.builder;
    float spacing = object["spacing"];
    if (spacing == 0.0f) spacing = builder.diameter();
    if (spacing < (1.0f - 1e-5f) * builder.diameter())
        failAt(context.path, pointer + "/spacing",
               fmt::format("{} m is below the diameter, {} m, so that grains would overlap; raise it, lower /diameter, "
                           "or give 0 for one diameter", spacing, builder.diameter()));
    const std::vector<Vector3f> lattice = fillRegion(context, object, pointer, spacing);
    uint32_t seed = object["seed"];
    Particle grain;
    grain.velocity = kind.velocity;
    grain.material = kind.material;
    grain.mass = builder.particleMass(kind.material);
    for (const Pose& pose : poses) {
        std::vector<Vector3f> positions = lattice;
        jitterPositions(positions, object["jitter"], seed++);
        for (const Vector3f& position : positions) {
            grain.position = grain.restPosition = pose.apply(position);
            builder.addLooseParticle(grain);
        }
    }
}

}  // namespace knuckle
