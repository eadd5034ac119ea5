#include "sim/world/animation/collider_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/base/errors.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

void require(bool holds, const char* what)
{
    if (!holds) throw std::logic_error(std::string("collider motion: ") + what);
}

}  // namespace

Animation animationOf(const ColliderMotion& motion)
{
    return {NO_INDEX, motion.pose, Vector3f::Zero(), {motion.play}};
}

std::vector<Collider> collidersAt(const World& world, double time)
{
    std::vector<Collider> colliders = world.colliders;
    const std::vector<AnimatedLink> one(1);
    for (const ColliderMotion& motion : world.colliderMotions) {
        const Pose frame = sampleAnimation(world, animationOf(motion), one, time).front();
        for (size_t k = 0; k < motion.places.size(); ++k) {
            Collider& collider = colliders.at(motion.firstCollider + k);
            collider.position = frame.apply(motion.places[k].translation);
            collider.orientation = (frame.rotation * motion.places[k].rotation).normalized();
        }
    }
    return colliders;
}

bool moves(const World& world, size_t collider)
{
    return std::ranges::any_of(world.colliderMotions, [&](const ColliderMotion& motion) {
        return collider >= motion.firstCollider && collider - motion.firstCollider < motion.places.size();
    });
}

void validateColliderMotions(const World& world)
{
    if (!world.colliderMotions.empty() && world.settings.solver != SolverKind::Impulse)
        throw InputError("the paper's solver has no colliders that move; take their `motion` away, or use solver "
                         "method impulse");
    uint32_t next = 0;
    for (const ColliderMotion& motion : world.colliderMotions) {
        require(motion.firstCollider >= next && !motion.places.empty(), "it moves nothing, or what another moves");
        next = motion.firstCollider + static_cast<uint32_t>(motion.places.size());
        require(next <= world.colliders.size(), "it moves colliders that are not there");
        require(motion.play.clip < world.clips.size(), "it plays a clip that is not there");
        require(world.clips[motion.play.clip].bodyCount == 1, "its clip is not of one body");
        require(motion.play.at == 0.0f && motion.play.speed >= 0.0f && motion.play.start >= 0.0f,
                "its clip does not begin at 0, or a time or speed is negative");
        require(motion.pose.translation.allFinite() && std::abs(motion.pose.rotation.norm() - 1.0f) < 1e-3f,
                "its place is not finite");
    }
}

}  // namespace knuckle
