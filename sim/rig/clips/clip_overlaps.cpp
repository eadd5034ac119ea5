#include "sim/rig/clips/clip_overlaps.h"

#include <algorithm>

#include "sim/rig/clips/joint_turns.h"

namespace knuckle {

namespace {

/// Most keys of a clip to check.
constexpr uint32_t LOOKS = 64;
/// Particles nearer than this lie in each other [diameters].
constexpr float OVERLAP = 0.9f;

/// The motion of each body from the rest pose at a key; the first stays where it is at rest.
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

/// Per body, the particles that no other body has.
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

/// The particles of a body at a key.
struct Placed {
    std::vector<uint32_t> particles;
    std::vector<Vector3f> places;
    Eigen::AlignedBox3f bounds;

    void add(uint32_t particle, const Vector3f& place)
    {
        particles.push_back(particle);
        places.push_back(place);
        bounds.extend(place);
    }
    /// Those nearer than a distance to a box.
    Placed near(const Eigen::AlignedBox3f& box, float distance) const
    {
        Placed found;
        for (size_t i = 0; i < places.size(); ++i)
            if (box.exteriorDistance(places[i]) < distance) found.add(particles[i], places[i]);
        return found;
    }
};

bool overlap(const Actor& actor, const Placed& whole, const Placed& other)
{
    const float distance = OVERLAP * actor.diameter;
    if (whole.bounds.exteriorDistance(other.bounds) >= distance) return false;
    const Placed a = whole.near(other.bounds, distance), b = other.near(a.bounds, distance);
    for (size_t i = 0; i < a.places.size(); ++i)
        for (size_t j = 0; j < b.places.size(); ++j)
            if ((a.places[i] - b.places[j]).squaredNorm() < distance * distance &&
                !touchAtRest(actor, a.particles[i], b.particles[j]))
                return true;
    return false;
}

std::vector<Placed> placedAt(const Actor& actor, const std::vector<std::vector<uint32_t>>& own,
                             const std::vector<Pose>& poses)
{
    std::vector<Placed> placed(own.size());
    for (size_t b = 0; b < own.size(); ++b)
        for (const uint32_t p : own[b]) placed[b].add(p, poses[b].apply(actor.particles[p]));
    return placed;
}

/// Two bodies, and in how many checked keys they overlap.
struct PairLooks {
    std::array<uint32_t, 2> bodies;
    uint32_t overlaps = 0;
};

std::vector<PairLooks> pairsThatTouch(const Actor& actor)
{
    std::vector<PairLooks> pairs;
    for (uint32_t a = 0; a < actor.bodies.size(); ++a)
        for (uint32_t b = a + 1; b < actor.bodies.size(); ++b)
            if (!actor.bodies[a].isCross && !actor.bodies[b].isCross && !neverTouch(actor, a, b))
                pairs.push_back({{a, b}});
    return pairs;
}

}  // namespace

std::vector<std::array<uint32_t, 2>> overlapsIn(const Actor& actor, const BodyClip& clip)
{
    const JointTurns joints(actor);
    const auto own = ownParticles(actor);
    std::vector<PairLooks> pairs = pairsThatTouch(actor);
    const uint32_t step = (clip.keyCount() + LOOKS - 1) / LOOKS;
    uint32_t looks = 0;
    for (uint32_t key = 0; key < clip.keyCount(); key += step, ++looks) {
        const std::vector<Placed> placed = placedAt(actor, own, posesAt(actor, joints, clip, key));
        for (PairLooks& pair : pairs)
            if (overlap(actor, placed[pair.bodies[0]], placed[pair.bodies[1]])) ++pair.overlaps;
    }
    std::vector<std::array<uint32_t, 2>> found;
    for (const PairLooks& pair : pairs)
        if (2 * pair.overlaps > looks) found.push_back(pair.bodies);
    return found;
}

}  // namespace knuckle
