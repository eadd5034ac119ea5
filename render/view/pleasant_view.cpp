#include "render/view/pleasant_view.h"

#include <algorithm>
#include <cmath>

#include "render/unseen.h"
#include "render/view/camera.h"
#include "sim/base/angles.h"
#include "sim/world/space/bounds.h"

namespace knuckle {

namespace {

using Eigen::AlignedBox3f;

constexpr float AZIMUTH = 28.0f * DEGREE;
constexpr float LOWEST = 17.0f * DEGREE, HIGHEST = 42.0f * DEGREE, STEP = 1.0f * DEGREE;

Vector3f directionAt(float elevation)
{
    return {std::sin(AZIMUTH) * std::cos(elevation), std::sin(elevation), std::cos(AZIMUTH) * std::cos(elevation)};
}

bool isInTheWay(const AlignedBox3f& box, const Vector3f& from, const Vector3f& direction)
{
    const Eigen::Array3f low = (box.min() - from).array() / direction.array();
    const Eigen::Array3f high = (box.max() - from).array() / direction.array();
    const float enters = low.min(high).maxCoeff(), leaves = low.max(high).minCoeff();
    return enters > 0.0f && enters < leaves;
}

}  // namespace

Vector3f pleasantDirection(const World& world)
{
    const SceneExtent extent = sceneExtent(world);
    const AlignedBox3f content = seenBounds(world);
    const auto hides = [&](const Collider& collider, float elevation) {
        if (!collider.visible || collider.shape != ColliderShape::Box) return false;
        const AlignedBox3f wall = colliderBounds(world, collider);
        // Things fall to the ground; half of what stands behind the wall is to be seen.
        const float top = std::min(content.max().y(), wall.max().y());
        const Vector3f middle(content.center().x(), 0.5f * (extent.ground + top), content.center().z());
        return isInTheWay(wall, middle, directionAt(elevation));
    };
    for (float elevation = LOWEST; !content.isEmpty() && elevation <= HIGHEST; elevation += STEP)
        if (std::ranges::none_of(world.colliders, [&](const Collider& c) { return hides(c, elevation); }))
            return directionAt(elevation);
    return directionAt(LOWEST);
}

}  // namespace knuckle
