#include "app/scene/matter/scene_fluid.h"

#include "app/scene/matter/scene_fill.h"
#include "app/scene/scene_materials.h"

namespace knuckle {

void addFluid(const ObjectEntry& entry)
{
    WorldBuilder& builder = entry.context.builder;
    requireFluid(entry.context, entry.material, entry.pointer + "/material");
    const std::vector<Vector3f> lattice = fillRegion(entry, builder.fluidSpacing());
    for (const Pose& pose : entry.poses) {
        std::vector<Vector3f> positions = lattice;
        for (Vector3f& position : positions) position = pose.apply(position);
        builder.addFluid(positions, entry.velocity, entry.material);
    }
}

}  // namespace knuckle
