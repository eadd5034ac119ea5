#include "sim/rig/bodies/body_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float TOUCH = 1.8f;        // lattice neighbours, including diagonal ones, are nearer than this [d]
constexpr float LOOSE = 2.6f;        // bodies further apart than this do not touch [d]
constexpr float NEAR_JOINT = 2.5f;   // a bone's head is its joint up to this distance from its body [d]
constexpr size_t PAIR_LIMIT = 1500;  // particles a side for measuring the distance of two bodies

using Particles = std::vector<uint32_t>;

float distanceTo(const Vector3f& point, const Particles& particles, const Voxels& voxels)
{
    float nearest = std::numeric_limits<float>::infinity();
    for (uint32_t particle : particles) {
        nearest = std::min(nearest, (voxels.positions[particle] - point).norm());
    }
    return nearest;
}

bool isBelow(const std::vector<BodyDraft>& drafts, int32_t body, int32_t ancestor)
{
    while (body >= 0 && body != ancestor) {
        body = drafts[body].parent;
    }
    return body == ancestor;
}

// Decides what hangs on what.
class Roots {
public:
    Roots(std::vector<BodyDraft>& drafts, const BoneTree& tree, std::span<const BoneAnatomy> anatomy,
          const Voxels& voxels)
        : drafts_(drafts), tree_(tree), anatomy_(anatomy), voxels_(voxels), root_(mainRoot())
    {
    }

    int32_t root() const { return root_; }

    // Joins the trees of a skeleton with several roots: starts from the trunk's, then always adds the root nearest to
    // the main tree.
    void join(std::vector<std::string>& notes)
    {
        while (true) {
            Candidate best;
            int32_t child = -1;
            for (int32_t b = 0; b < count(); ++b) {
                if (b == root_ || drafts_[b].parent >= 0) continue;
                const Candidate found = nearestInSkeleton(b);
                const std::tuple order(isSided(b), found.order()), first(child >= 0 && isSided(child), best.order());
                if (child >= 0 && order >= first) continue;
                best = found;
                child = b;
            }
            if (child < 0) return;
            // The root is not part of the main tree yet.
            const bool apart = best.contact.distance > LOOSE * voxels_.diameter;
            const int32_t atHead = apart ? bodyAtHead(child, best.unfit) : -1;
            drafts_[child].parent = atHead >= 0 ? atHead : best.body;
            const char* why = atHead >= 0              ? "where its head is"
                              : best.steps == NO_INDEX ? "the body nearest to it"
                                                       : "next to it in the skeleton";
            notes.push_back(
                fmt::format("{} is joined to {}, {}.", drafts_[child].name, drafts_[drafts_[child].parent].name, why));
        }
    }

private:
    // A body to hang on: how badly it fits, number of bones to it, distance of the particles.
    struct Candidate {
        int32_t body = -1;
        int unfit = 0;
        uint32_t steps = NO_INDEX;
        Contact contact;

        std::tuple<int, uint32_t, float> order() const { return {unfit, steps, contact.distance}; }
    };

    int32_t count() const { return static_cast<int32_t>(drafts_.size()); }
    const BoneAnatomy& boneOf(int32_t body) const { return anatomy_[drafts_[body].bone]; }
    bool isSided(int32_t body) const { return boneOf(body).side != 0; }

    // The hips, if they are a root, else the parentless body that most particles hang from, preferably not a limb.
    int32_t mainRoot() const
    {
        std::vector<size_t> weight(drafts_.size(), 0);
        int32_t best = -1;
        for (int32_t b = count(); b-- > 0;) {
            weight[b] += drafts_[b].particles.size();
            if (drafts_[b].parent >= 0) weight[drafts_[b].parent] += weight[b];
        }
        for (int32_t b = 0; b < count(); ++b) {
            if (drafts_[b].parent >= 0) continue;
            if (boneOf(b).part == BodyPart::Hips) return b;
            const std::tuple order(!isSided(b), weight[b]);
            if (best < 0 || order > std::tuple(!isSided(best), weight[best])) best = b;
        }
        return best;
    }

    // 0 for a body that fits: the trunk for a limb, its own side for a limb's end. 2 for the other side, the last
    // resort.
    int unfitness(int32_t body, int32_t other) const
    {
        using enum BodyPart;
        const BoneAnatomy &own = boneOf(body), &bone = boneOf(other);
        if (own.side != 0 && bone.side == -own.side) return 2;
        const bool isTrunk = bone.part == Hips || bone.part == Spine;
        if (own.part == Thigh || own.part == Coxa || own.part == Clavicle || own.part == UpperArm)
            return isTrunk ? 0 : 1;
        const bool ofTrunk = own.part == Hips || own.part == Spine || own.part == Neck || own.part == Head ||
                             own.part == Tail;
        return ofTrunk && bone.side != 0 ? 1 : 0;
    }

    Candidate nearestInSkeleton(int32_t body) const
    {
        const std::vector<uint32_t> steps = tree_.stepsFrom(drafts_[body].bone);
        Candidate best;
        for (int32_t other = 0; other < count(); ++other) {
            Candidate found{other, unfitness(body, other), steps[drafts_[other].bone], {}};
            const std::tuple order(found.unfit, found.steps);
            if (!isBelow(drafts_, other, root_) || (best.body >= 0 && order > std::tuple(best.unfit, best.steps)))
                continue;
            found.contact = contactOf(drafts_[body].particles, drafts_[other].particles, voxels_);
            if (best.body < 0 || found.order() < best.order()) best = found;
        }
        return best;
    }

    // The body whose particles are at the bone's head; none if no body that fits as well is that near.
    int32_t bodyAtHead(int32_t body, int unfit) const
    {
        float nearest = TOUCH * voxels_.diameter;
        int32_t best = -1;
        for (int32_t other = 0; other < count(); ++other) {
            if (!isBelow(drafts_, other, root_) || unfitness(body, other) > unfit) continue;
            const float distance = distanceTo(drafts_[body].anchor, drafts_[other].particles, voxels_);
            if (distance < nearest) best = other;
            nearest = std::min(nearest, distance);
        }
        return best;
    }

    std::vector<BodyDraft>& drafts_;
    const BoneTree& tree_;
    std::span<const BoneAnatomy> anatomy_;
    const Voxels& voxels_;
    int32_t root_;
};

// Joints move to where the bodies meet if the bone's head is away from there.
void tightenJoints(std::vector<BodyDraft>& drafts, int32_t root, const Voxels& voxels, std::vector<std::string>& notes)
{
    const float d = voxels.diameter;
    for (int32_t b = 0; b < static_cast<int32_t>(drafts.size()); ++b) {
        if (b == root) continue;
        BodyDraft& body = drafts[b];
        const BodyDraft& parent = drafts[body.parent];
        const Contact contact = contactOf(body.particles, parent.particles, voxels);
        const bool offBody = distanceTo(body.anchor, body.particles, voxels) > NEAR_JOINT * d;
        const bool offParent = distanceTo(body.anchor, parent.particles, voxels) > NEAR_JOINT * d;
        if (!offBody && !(offParent && contact.distance < TOUCH * d)) continue;
        notes.push_back(fmt::format("The joint of {} sits where it meets {}, since the bone's head is away from it.",
                                    body.name, parent.name));
        body.anchor = contact.middle;
    }
}

// Parents first, otherwise in the old order.
std::vector<BodyDraft> parentsFirst(std::vector<BodyDraft> drafts)
{
    std::vector<int32_t> order, place(drafts.size(), -1);
    for (size_t i = 0; order.size() < drafts.size(); ++i) {
        const int32_t above = i == 0 ? -1 : order[i - 1];
        for (int32_t b = 0; b < static_cast<int32_t>(drafts.size()); ++b) {
            if (drafts[b].parent == above) {
                place[b] = static_cast<int32_t>(order.size());
                order.push_back(b);
            }
        }
    }
    std::vector<BodyDraft> sorted;
    for (int32_t b : order) {
        sorted.push_back(std::move(drafts[b]));
        sorted.back().parent = sorted.back().parent < 0 ? -1 : place[sorted.back().parent];
    }
    return sorted;
}

}  // namespace

Contact contactOf(const Particles& a, const Particles& b, const Voxels& voxels)
{
    const size_t strideA = a.size() / PAIR_LIMIT + 1, strideB = b.size() / PAIR_LIMIT + 1;
    Contact contact;
    for (const bool measure : {true, false}) {
        Vector3f sum = Vector3f::Zero();
        int pairs = 0;
        for (size_t i = 0; i < a.size(); i += strideA) {
            for (size_t j = 0; j < b.size(); j += strideB) {
                const Vector3f &p = voxels.positions[a[i]], &q = voxels.positions[b[j]];
                const float distance = (p - q).norm();
                if (measure) {
                    contact.distance = std::min(contact.distance, distance);
                } else if (distance < contact.distance + 0.3f * voxels.diameter) {
                    sum += 0.5f * (p + q);
                    ++pairs;
                }
            }
        }
        contact.middle = pairs > 0 ? Vector3f(sum / static_cast<float>(pairs)) : contact.middle;
    }
    return contact;
}

void arrangeTree(std::vector<BodyDraft>& drafts, const BoneTree& tree, std::span<const BoneAnatomy> anatomy,
                 const Voxels& voxels, std::vector<std::string>& notes)
{
    Roots roots(drafts, tree, anatomy, voxels);
    roots.join(notes);
    tightenJoints(drafts, roots.root(), voxels, notes);
    drafts = parentsFirst(std::move(drafts));
}

}  // namespace knuckle
