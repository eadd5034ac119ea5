#include "sim/solver/measure/animated_depths.h"

#include <algorithm>
#include <cmath>

#include "sim/solver/measure/measure.h"

namespace knuckle {

namespace {

constexpr float INTERVAL = 0.05f;  // [s]

/// Until when clips surely move all of an object [s].
float animatedUntil(const World& world, const Object& object, float duration)
{
    for (uint32_t b = object.bodyStart; b < object.bodyStart + object.bodyCount; ++b) {
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

void raise(AnimatedDepth& deepest, float depth, float time)
{
    if (depth <= deepest.depth) return;
    deepest.depth = depth;
    deepest.time = time;
}

AnimatedDepth deepestInColliders(const World& world, const Animation& animation, float until)
{
    AnimatedDepth deepest{animation.object, NO_INDEX, NO_INDEX, 0.0f, 0.0f};
    for (float time = 0.0f; time < until; time += INTERVAL)
        for (const Vector3f& place : placedAt(world, animation, time).places)
            for (uint32_t c = 0; c < world.colliders.size(); ++c) {
                const float before = deepest.depth;
                raise(deepest, world.particleRadius - colliderDistance(world, world.colliders[c], place), time);
                if (deepest.depth > before) deepest.collider = c;
            }
    return deepest;
}

/// How far two objects are in each other: the least extent of what both fill.
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

AnimatedDepth deepestInOthers(const World& world, size_t index, float until)
{
    const Animation& animation = world.animations[index];
    AnimatedDepth deepest{animation.object, NO_INDEX, NO_INDEX, 0.0f, 0.0f};
    for (size_t other = index + 1; other < world.animations.size(); ++other) {
        const float both = std::min(until, animatedUntil(world, world.objects[world.animations[other].object], until));
        for (float time = 0.0f; time < both; time += INTERVAL) {
            const float before = deepest.depth;
            raise(deepest,
                  depthBetween(world, placedAt(world, animation, time), placedAt(world, world.animations[other], time)),
                  time);
            if (deepest.depth > before) deepest.other = world.animations[other].object;
        }
    }
    return deepest;
}

}  // namespace

std::vector<AnimatedDepth> animatedDepths(const World& world, float duration)
{
    std::vector<AnimatedDepth> depths;
    for (size_t i = 0; i < world.animations.size(); ++i) {
        const Object& object = world.objects[world.animations[i].object];
        const float until = animatedUntil(world, object, duration);
        for (const AnimatedDepth& deepest :
             {deepestInColliders(world, world.animations[i], until), deepestInOthers(world, i, until)})
            if (deepest.depth > world.diameter()) depths.push_back(deepest);
    }
    return depths;
}

}  // namespace knuckle
