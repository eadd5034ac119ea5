#include <fmt/format.h>

#include "app/scene_fill.h"
#include "app/scene_parts.h"

namespace knuckle {

void addFluid(SceneContext& context, const Json& object, const std::string& pointer, const LooseKind& kind,
              const std::vector<Pose>& poses)
{
    WorldBuilder& builder = context.builder;
    if (!builder.material(kind.material).fluid)
        failAt(context.path, pointer + "/material",
               fmt::format("\"{}\" is not a fluid; give that material \"fluid\": true, or take another",
                           builder.material(kind.material).name));
    const std::vector<Vector3f> lattice = fillRegion(context, object, pointer, builder.fluidSpacing());
    for (const Pose& pose : poses) {
        std::vector<Vector3f> positions = lattice;
        for (Vector3f& position : positions) position = pose.apply(position);
        builder.addFluid(positions, kind.velocity, kind.material);
    }
}

}  // namespace knuckle
