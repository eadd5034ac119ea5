#include "app/scene/matter/scene_fluid.h"

#include <algorithm>

#include "app/scene/matter/scene_fill.h"
#include "app/scene/scene_materials.h"
#include "sim/world/collider_distance.h"

namespace knuckle {

namespace {

bool isInCollider(const World& world, const Vector3f& x)
{
    return std::ranges::any_of(world.colliders,
                               [&](const Collider& c) { return colliderDistance(world, c, x) < 0.0f; });
}

}  // namespace

void addFluid(const ObjectEntry& entry)
{
    WorldBuilder& builder = entry.context.builder;
    requireFluid(entry.context, entry.material, entry.pointer + "/material");
    const std::vector<Vector3f> lattice = fillRegion(entry, builder.fluidSpacing());
    for (size_t copy = 0; copy < entry.poses.size(); ++copy) {
        std::vector<Vector3f> positions = lattice;
        for (Vector3f& position : positions) position = entry.poses[copy].apply(position);
        std::erase_if(positions, [&](const Vector3f& x) { return isInCollider(builder.world(), x); });
        if (positions.empty()) entry.fail("", "all of it is inside colliders; move it, or make it larger");
        builder.addFluid(positions, entry.velocity, entry.material, entry.copyName(copy),
                         entry.json.value("visible", true));
    }
}

}  // namespace knuckle
