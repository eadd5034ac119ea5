#include "sim/rig/clips/ground_contact.h"

#include <algorithm>

#include "sim/rig/clips/body_clip.h"
#include "sim/rig/clips/joint_turns.h"

namespace knuckle {

namespace {

constexpr float LIFTED = 0.03f;   // of the figure's height: above the ground by more than this, nothing touches
constexpr float TOUCHING = 0.5f;  // [diameters] above the lowest particle
constexpr float SLOW = 0.15f;     // up or down [m/s]: at this speed a particle counts half

/// Finds where the particles of an actor are at the keys of a clip.
class Poser {
public:
    Poser(const Actor& actor, const BodyClip& clip)
        : actor_(actor), clip_(clip), order_(JointTurns(actor).order()), anchors_(actor.bodies.size(), pivotOf(actor)),
          parents_(actor.bodies.size(), -1), bodyOf_(actor.particles.size(), NO_INDEX)
    {
        for (const ActorJoint& joint : actor.joints) {
            parents_[joint.child] = static_cast<int32_t>(joint.parent);
            Vector3f sum(0, 0, 0);
            for (const uint32_t p : joint.sharedParticles) sum += actor.particles[p];
            anchors_[joint.child] = joint.sharedParticles.empty() ? joint.anchor
                                                                  : Vector3f(sum / float(joint.sharedParticles.size()));
        }
        for (uint32_t b = 0; b < actor.bodies.size(); ++b)
            for (const uint32_t p : actor.bodies[b].particles) bodyOf_[p] = b;
    }

    std::vector<Vector3f> at(uint32_t key) const
    {
        std::vector<Eigen::Isometry3f> poses(actor_.bodies.size(), Eigen::Isometry3f::Identity());
        for (const uint32_t b : order_) {
            const Quaternionf& turn = clip_.turns[key * clip_.bodyCount + b];
            const bool isFirst = parents_[b] < 0;
            Eigen::Isometry3f above = Eigen::Isometry3f::Identity();
            if (!isFirst) above = poses[static_cast<size_t>(parents_[b])];
            poses[b] = above * Eigen::Translation3f(isFirst ? clip_.roots[key] : anchors_[b]) * turn *
                       Eigen::Translation3f(-anchors_[b]);
        }
        std::vector<Vector3f> places;
        for (uint32_t p = 0; p < actor_.particles.size(); ++p)
            places.push_back(bodyOf_[p] == NO_INDEX ? actor_.particles[p]
                                                    : Vector3f(poses[bodyOf_[p]] * actor_.particles[p]));
        return places;
    }

private:
    const Actor& actor_;
    const BodyClip& clip_;
    std::vector<uint32_t> order_;
    std::vector<Vector3f> anchors_;
    std::vector<int32_t> parents_;
    std::vector<uint32_t> bodyOf_;
};

float lowestOf(const std::vector<Vector3f>& places)
{
    float lowest = places.front().y();
    for (const Vector3f& p : places) lowest = std::min(lowest, p.y());
    return lowest;
}

GroundContact contactBetween(const std::vector<Vector3f>& before, const std::vector<Vector3f>& after, float diameter,
                             float rate)
{
    GroundContact contact;
    const float reach = TOUCHING * diameter, from = lowestOf(before), to = lowestOf(after);
    float sum = 0.0f;
    for (size_t p = 0; p < before.size(); ++p) {
        const float above = std::max(before[p].y() - from, after[p].y() - to) / reach;
        if (above >= 1.0f) continue;
        const float rise = rate * (after[p].y() - before[p].y()) / SLOW, weight = (1.0f - above) / (1.0f + rise * rise);
        contact.before += weight * groundOf(before[p]);
        contact.after += weight * groundOf(after[p]);
        sum += weight;
    }
    if (sum <= 0.0f) return contact;
    contact.before /= sum;
    contact.after /= sum;
    contact.isThere = true;
    return contact;
}

}  // namespace

std::vector<GroundContact> groundContacts(const Actor& actor, const BodyClip& clip)
{
    const Poser poser(actor, clip);
    std::vector<std::vector<Vector3f>> keys;
    for (uint32_t k = 0; k < clip.keyCount(); ++k) keys.push_back(poser.at(k));
    std::vector<float> lowest;
    std::ranges::transform(keys, std::back_inserter(lowest), lowestOf);
    float highest = keys[0][0].y();
    for (const Vector3f& p : keys[0]) highest = std::max(highest, p.y());
    const float ground = *std::ranges::min_element(lowest), lifted = ground + LIFTED * (highest - ground);
    std::vector<GroundContact> contacts;
    for (size_t k = 0; k + 1 < keys.size(); ++k) {
        const bool isDown = std::max(lowest[k], lowest[k + 1]) <= lifted;
        contacts.push_back(isDown ? contactBetween(keys[k], keys[k + 1], actor.diameter, clip.rate) : GroundContact{});
    }
    return contacts;
}

}  // namespace knuckle
