#include "tests/physics/animation/moving_fixture.h"

#include <cmath>

namespace knuckle::test {

BodyClip motionOf(float seconds, const std::function<Pose(float)>& poseAt)
{
    BodyClip clip{"motion", 60.0f, 1};
    const int count = static_cast<int>(std::lround(60.0f * seconds));
    for (int k = 0; k <= count; ++k) {
        const Pose pose = poseAt(static_cast<float>(k) / 60.0f);
        clip.roots.push_back(pose.translation);
        clip.turns.push_back(pose.rotation);
    }
    return clip;
}

BodyClip straightMotion(const Vector3f& velocity, float seconds)
{
    return motionOf(seconds, [&](float t) { return Pose{t * velocity}; });
}

void addMovingBox(WorldBuilder& builder, const Vector3f& place, const Vector3f& halfExtents, BodyClip clip)
{
    Collider box;
    box.shape = ColliderShape::Box;
    box.position = place;
    box.halfExtents = halfExtents;
    builder.addCollider(box);
    builder.moveColliders(1, {place}, {.clip = builder.addClip(std::move(clip)), .loop = false});
}

}  // namespace knuckle::test
