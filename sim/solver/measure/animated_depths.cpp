#include "sim/solver/measure/animated_depths.h"

#include <algorithm>
#include <optional>

#include "sim/solver/measure/measure.h"
#include "sim/world/collider_distance.h"

namespace knuckle {

namespace {

constexpr float INTERVAL = 0.05f;  // [s]

/// The time until which clips certainly move all of an object [s].
float animatedUntil(const World& world, const Object& object, float duration)
{
    for (uint32_t b = object.bodyStart; b < object.bodyEnd(); ++b) {
        duration = std::min(duration, world.bodies[b].releaseTime);
        if (world.bodies[b].watched) duration = 0.0f;
    }
    return duration;
}

/// An animated object at a moment.
struct Placed {
    std::vector<Vector3f> places;  ///< Of its particles [m].
    Eigen::AlignedBox3f bounds;
};

Placed placedAt(const World& world, const Animation& animation, float time)
{
    Placed placed;
    const Object& object = world.objects[animation.object];
    const std::vector<Pose> poses = bodyPlaces(world, animation, double{time});
    for (uint32_t b = 0; b < object.bodyCount; ++b) {
        const Body& body = world.bodies[object.bodyStart + b];
        for (uint32_t k = body.linkStart; k < body.linkStart + body.linkCount; ++k) {
            placed.places.push_back(poses[b].apply(world.links[k].restOffset));
            placed.bounds.extend(placed.places.back());
        }
    }
    return placed;
}

void raiseByColliders(AnimatedDepth& deepest, const World& world, const std::vector<Collider>& colliders,
                      const Placed& placed, float time)
{
    for (const Vector3f& place : placed.places)
        for (uint32_t c = 0; c < colliders.size(); ++c) {
            const float depth = world.particleRadius - colliderDistance(world, colliders[c], place);
            if (depth > deepest.depth) deepest = {deepest.object, NO_INDEX, c, depth, time};
        }
}

/// How far two objects overlap: the least extent of the space that both fill.
float depthBetween(const World& world, const Placed& a, const Placed& b)
{
    const float d = world.diameter();
    const Eigen::AlignedBox3f common = a.bounds.intersection(b.bounds);
    if (common.isEmpty()) return 0.0f;
    const auto near = [&](const Vector3f& p) { return common.exteriorDistance(p) < d; };
    Eigen::AlignedBox3f filled;
    float least = d;
    for (const Vector3f& p : a.places)
        for (const Vector3f& q : b.places) {
            const float distance = near(p) && near(q) ? (p - q).norm() : d;
            if (distance >= 0.9f * d) continue;
            filled.extend(0.5f * (p + q));
            least = std::min(least, distance);
        }
    return filled.isEmpty() ? 0.0f : filled.sizes().minCoeff() + d - least;
}

/// Compares with the objects from an index on.
void raiseByOthers(AnimatedDepth& deepest, const World& world, const std::vector<std::optional<Placed>>& placed,
                   size_t index, float time)
{
    for (size_t other = index + 1; other < placed.size(); ++other) {
        if (!placed[other]) continue;
        const float depth = depthBetween(world, *placed[index], *placed[other]);
        if (depth > deepest.depth) deepest = {deepest.object, world.animations[other].object, NO_INDEX, depth, time};
    }
}

}  // namespace

std::vector<AnimatedDepth> animatedDepths(const World& world, float duration)
{
    const size_t count = world.animations.size();
    std::vector<AnimatedDepth> inColliders(count), inOthers(count);
    std::vector<float> until(count);
    for (size_t i = 0; i < count; ++i) {
        inColliders[i].object = inOthers[i].object = world.animations[i].object;
        until[i] = animatedUntil(world, world.objects[world.animations[i].object], duration);
    }
    for (float time = 0.0f; time < duration; time += INTERVAL) {
        std::vector<std::optional<Placed>> placed(count);
        const std::vector<Collider> colliders = collidersAt(world, double{time});
        for (size_t i = 0; i < count; ++i)
            if (time < until[i]) placed[i] = placedAt(world, world.animations[i], time);
        for (size_t i = 0; i < count; ++i) {
            if (!placed[i]) continue;
            raiseByColliders(inColliders[i], world, colliders, *placed[i], time);
            raiseByOthers(inOthers[i], world, placed, i, time);
        }
    }
    std::vector<AnimatedDepth> depths;
    for (size_t i = 0; i < count; ++i)
        for (const AnimatedDepth& deepest : {inColliders[i], inOthers[i]})
            if (deepest.depth > world.diameter()) depths.push_back(deepest);
    return depths;
}

}  // namespace knuckle
