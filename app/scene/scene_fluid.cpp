#include <fmt/format.h>

#include "app/scene/scene_fill.h"
#include "app/scene/scene_parts.h"

namespace knuckle {

void requireFluid(const SceneContext& context, uint32_t material, const std::string& pointer)
{
    const Material& found = context.builder.material(material);
    if (!found.fluid)
        failAt(context.path, pointer,
               fmt::format("\"{}\" is not a fluid; give that material \"fluid\": true, or take another", found.name));
}

void addFluid(SceneContext& context, const Json& object, const std::string& pointer, const LooseKind& kind,
              const std::vector<Pose>& poses)
{
    WorldBuilder& builder = context.builder;
    requireFluid(context, kind.material, pointer + "/material");
    const std::vector<Vector3f> lattice = fillRegion(context, object, pointer, builder.fluidSpacing());
    for (const Pose& pose : poses) {
        std::vector<Vector3f> positions = lattice;
        for (Vector3f& position : positions) position = pose.apply(position);
        builder.addFluid(positions, kind.velocity, kind.material);
    }
}

}  // namespace knuckle
