#include "sim/actor/clips/clip_overlaps.h"

#include <algorithm>

#include "sim/actor/clips/joint_turns.h"

namespace knuckle {

namespace {

/// Keys of a clip that are looked at, at most.
constexpr uint32_t LOOKS = 64;
/// Particles nearer than this lie in each other [diameters].
constexpr float OVERLAP = 0.9f;

/// Of each body its motion from the rest pose at a key; the first stands where it does at rest.
std::vector<Pose> posesAt(const Actor& actor, const JointTurns& joints, const BodyClip& clip, uint32_t key)
{
    std::vector<Pose> poses(actor.bodies.size());
    for (const uint32_t b : joints.order()) {
        const auto joint = std::ranges::find(actor.joints, b, &ActorJoint::child);
        if (joint == actor.joints.end()) continue;
        const Pose& parent = poses[joint->parent];
        const Quaternionf turn = (parent.rotation * clip.turns[size_t{key} * clip.bodyCount + b]).normalized();
        poses[b] = {parent.apply(joint->anchor) - turn * joint->anchor, turn};
    }
    return poses;
}

/// The particles of a body that no other has.
std::vector<std::vector<uint32_t>> ownParticles(const Actor& actor)
{
    std::vector<uint32_t> owners(actor.particles.size());
    for (const ActorBody& body : actor.bodies)
        for (const uint32_t p : body.particles) ++owners[p];
    std::vector<std::vector<uint32_t>> own(actor.bodies.size());
    for (size_t b = 0; b < own.size(); ++b)
        for (const uint32_t p : actor.bodies[b].particles)
            if (owners[p] == 1) own[b].push_back(p);
    return own;
}

/// Bodies at a key.
struct Placed {
    std::vector<std::vector<Vector3f>> places;  ///< Of each body's own particles.
    std::vector<Eigen::AlignedBox3f> bounds;
};

Placed placedAt(const Actor& actor, const std::vector<std::vector<uint32_t>>& own, const std::vector<Pose>& poses)
{
    Placed placed{std::vector<std::vector<Vector3f>>(own.size()), std::vector<Eigen::AlignedBox3f>(own.size())};
    for (size_t b = 0; b < own.size(); ++b)
        for (const uint32_t p : own[b]) {
            placed.places[b].push_back(poses[b].apply(actor.particles[p]));
            placed.bounds[b].extend(placed.places[b].back());
        }
    return placed;
}

}  // namespace

std::vector<std::array<uint32_t, 2>> overlapsIn(const Actor& actor, const BodyClip& clip)
{
    const JointTurns joints(actor);
    const auto own = ownParticles(actor);
    const float near = OVERLAP * actor.diameter;
    const auto overlap = [&](const Placed& placed, uint32_t a, uint32_t b) {
        if (placed.bounds[a].exteriorDistance(placed.bounds[b]) >= near) return false;
        for (size_t i = 0; i < own[a].size(); ++i)
            for (size_t j = 0; j < own[b].size(); ++j)
                if ((placed.places[a][i] - placed.places[b][j]).norm() < near &&
                    !touchAtRest(actor, own[a][i], own[b][j]))
                    return true;
        return false;
    };
    const auto count = static_cast<uint32_t>(actor.bodies.size()), step = (clip.keyCount() + LOOKS - 1) / LOOKS;
    std::vector<uint32_t> times(size_t{count} * count);
    uint32_t looks = 0;
    for (uint32_t key = 0; key < clip.keyCount(); key += step, ++looks) {
        const Placed placed = placedAt(actor, own, posesAt(actor, joints, clip, key));
        for (uint32_t a = 0; a < count; ++a)
            for (uint32_t b = a + 1; b < count; ++b)
                if (!actor.bodies[a].isCross && !actor.bodies[b].isCross && overlap(placed, a, b))
                    ++times[size_t{a} * count + b];
    }
    std::vector<std::array<uint32_t, 2>> pairs;
    for (uint32_t a = 0; a < count; ++a)
        for (uint32_t b = a + 1; b < count; ++b)
            if (2 * times[size_t{a} * count + b] > looks && !neverTouch(actor, a, b)) pairs.push_back({a, b});
    return pairs;
}

}  // namespace knuckle
