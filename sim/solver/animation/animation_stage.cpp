#include "sim/solver/animation/animation_stage.h"

#include <algorithm>

#include "shared/contact_constants.h"
#include "sim/solver/pack.h"

namespace knuckle {

namespace {

/// Where each clip's keys begin.
struct Starts {
    std::vector<uint32_t> turns, roots;
};

void addPlays(std::vector<gpu::ClipPlay>& out, const World& world, const Animation& animation, const Starts& starts)
{
    const PlayPlaces places = placePlays(world, animation);
    for (size_t i = 0; i < animation.plays.size(); ++i) {
        const ClipPlay& play = animation.plays[i];
        const BodyClip& clip = world.clips[play.clip];
        const GroundMotion &start = places.starts[i], &round = places.loops[i];
        gpu::ClipPlay p{};
        p.firstTurn = starts.turns[play.clip];
        p.firstRoot = starts.roots[play.clip];
        p.keyCount = clip.keyCount();
        p.bodyCount = clip.bodyCount;
        p.at = play.at;
        p.firstKey = play.start * clip.rate;
        p.keyRate = play.speed * clip.rate;
        p.fade = play.fade;
        p.loop = play.loop ? 1 : 0;
        p.inPlace = play.inPlace ? 1 : 0;
        p.yaw = start.yaw;
        p.roundYaw = round.yaw;
        p.shift = pack(start.shift, 0);
        p.roundShift = pack(round.yaw == 0.0f ? round.shift : round.centre(), 0);
        out.push_back(p);
    }
}

uint32_t puppetOf(const World& world, uint32_t animation)
{
    const auto found = std::ranges::find(world.puppets, animation, &Puppet::animation);
    return found == world.puppets.end() ? NO_INDEX : static_cast<uint32_t>(found - world.puppets.begin());
}

/// From the place of a collider to its farthest point [m].
float reachOf(const World& world, const Collider& collider)
{
    switch (collider.shape) {
        case ColliderShape::Plane: return PLANE_REACH;
        case ColliderShape::Box: return collider.halfExtents.norm();
        case ColliderShape::Sphere: return collider.radius;
        case ColliderShape::Capsule: return collider.radius + collider.halfHeight;
        case ColliderShape::Mesh:
        case ColliderShape::Heightfield: {
            const ColliderGrid& grid = world.colliderGrids[collider.grid];
            return grid.drawnLow.cwiseAbs().cwiseMax(grid.drawnHigh.cwiseAbs()).norm();
        }
    }
    return 0.0f;
}

}  // namespace

AnimationStage::AnimationStage(const StageSetup& setup)
    : parameters_(setup.parameters), hasBodies_(!setup.world.animations.empty()),
      hasColliders_(!setup.world.colliderMotions.empty()), hasFluids_(setup.world.fluidCount > 0)
{
}

void AnimationStage::upload(const StageSetup& setup)
{
    const World& world = setup.world;
    Starts starts;
    std::vector<gpu::vec4> turns, roots;
    for (const BodyClip& clip : world.clips) {
        starts.turns.push_back(static_cast<uint32_t>(turns.size()));
        starts.roots.push_back(static_cast<uint32_t>(roots.size()));
        for (const Quaternionf& turn : clip.turns) turns.push_back(pack(turn));
        for (const Vector3f& root : clip.roots) roots.push_back(pack(root, 0));
    }
    std::vector<gpu::Animation> placed;
    std::vector<gpu::ClipPlay> plays;
    const auto add = [&](const Animation& animation, uint32_t puppet) {
        placed.push_back({pack(animation.pose.translation, 0), pack(animation.pose.rotation),
                          static_cast<uint32_t>(plays.size()), static_cast<uint32_t>(animation.plays.size()), puppet,
                          0});
        addPlays(plays, world, animation, starts);
    };
    for (uint32_t a = 0; a < world.animations.size(); ++a) add(world.animations[a], puppetOf(world, a));
    for (const ColliderMotion& motion : world.colliderMotions) add(animationOf(motion), NO_INDEX);
    clipTurns = {"clipTurns", std::span<const gpu::vec4>(turns)};
    clipRoots = {"clipRoots", std::span<const gpu::vec4>(roots)};
    animations = {"animations", std::span<const gpu::Animation>(placed)};
    clipPlays = {"clipPlays", std::span<const gpu::ClipPlay>(plays)};
    addBodies(setup);
    addColliders(setup);
}

void AnimationStage::addBodies(const StageSetup& setup)
{
    const World& world = setup.world;
    std::vector<gpu::AnimatedBody> bodies;
    for (uint32_t a = 0; a < world.animations.size(); ++a) {
        const Animation& animation = world.animations[a];
        const uint32_t first = setup.layout.firstAnimated[a];
        const std::vector<AnimatedLink> links = linksOf(world, animation);
        for (uint32_t b = 0; b < links.size(); ++b) {
            const uint32_t body = objectOf(world, animation).bodyStart + b;
            bodies.push_back({body, links[b].parent == NO_INDEX ? NO_INDEX : first + links[b].parent, a, b,
                              pack(world.bodies[body].restCentre, 0), pack(links[b].anchor, 0)});
        }
    }
    setup.parameters.animatedCount = static_cast<uint32_t>(bodies.size());
    animatedBodies = {"animatedBodies", std::span<const gpu::AnimatedBody>(bodies)};
    const size_t driven = world.puppets.empty() ? 0 : bodies.size();
    clipBodyTurns = {"clipBodyTurns", driven};
    clipBodyPlaces = {"clipBodyPlaces", 2 * driven};
    clipBodyTurns.clear();
    clipBodyPlaces.clear();
}

void AnimationStage::addColliders(const StageSetup& setup)
{
    const World& world = setup.world;
    std::vector<gpu::MovingCollider> moving;
    std::vector<gpu::vec4> founds;
    auto animation = static_cast<uint32_t>(world.animations.size());
    for (const ColliderMotion& motion : world.colliderMotions) {
        for (uint32_t k = 0; k < motion.places.size(); ++k) {
            const Collider& collider = world.colliders[motion.firstCollider + k];
            moving.push_back({motion.firstCollider + k, animation, reachOf(world, collider), 0,
                              pack(motion.places[k].translation, 0), pack(motion.places[k].rotation)});
            founds.push_back(pack(collider.position, 0));
            founds.push_back(pack(collider.orientation));
        }
        ++animation;
    }
    setup.parameters.movingColliderCount = static_cast<uint32_t>(moving.size());
    movingColliders = {"movingColliders", std::span<const gpu::MovingCollider>(moving)};
    colliderFounds = {"colliderFounds", std::span<const gpu::vec4>(founds)};
}

void AnimationStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, clipTurns, clipRoots, animatedBodies, animations, clipPlays, movingColliders);
    table.add(Lifetime::State, clipBodyTurns, clipBodyPlaces, colliderFounds);
}

void AnimationStage::lookAhead(Recorder& recorder) const
{
    if (hasFluids_) recorder.perElement(lookAhead_, parameters_.movingColliderCount);
}

void AnimationStage::animate(Recorder& recorder) const
{
    recorder.perElement(animate_, parameters_.animatedCount);
    recorder.perElement(moveColliders_, parameters_.movingColliderCount);
}

}  // namespace knuckle
