#include "sim/actor/bodies/body_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float TOUCH = 1.8f;        // lattice neighbours, diagonals included, are nearer than this [d]
constexpr float LOOSE = 2.6f;        // bodies farther apart than this do not touch [d]
constexpr float NEAR_JOINT = 2.5f;   // a bone's head is its joint up to this distance from its body [d]
constexpr size_t PAIR_LIMIT = 1500;  // particles a side when two bodies' distance is measured

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

// The hips, where they are a root, else the parentless body that most particles hang from.
int32_t mainRoot(const std::vector<BodyDraft>& drafts, std::span<const BoneAnatomy> anatomy)
{
    for (size_t b = 0; b < drafts.size(); ++b)
        if (drafts[b].parent < 0 && anatomy[drafts[b].bone].part == BodyPart::Hips) return static_cast<int32_t>(b);
    std::vector<size_t> weight(drafts.size(), 0);
    int32_t best = 0;
    for (size_t b = drafts.size(); b-- > 0;) {
        weight[b] += drafts[b].particles.size();
        if (drafts[b].parent >= 0) {
            weight[drafts[b].parent] += weight[b];
        }
    }
    for (size_t b = 1; b < drafts.size(); ++b) {
        if (drafts[b].parent < 0 && (drafts[best].parent >= 0 || weight[b] > weight[best])) {
            best = static_cast<int32_t>(b);
        }
    }
    return best;
}

// A body to hang on: how many bones away, how near its particles come.
struct Candidate {
    int32_t body = -1;
    uint32_t steps = NO_INDEX;
    Contact contact;
};

Candidate nearestInSkeleton(const std::vector<BodyDraft>& drafts, int32_t body, int32_t root, const BoneTree& tree,
                            const Voxels& voxels)
{
    const std::vector<uint32_t> steps = tree.stepsFrom(drafts[body].bone);
    Candidate best;
    for (int32_t other = 0; other < static_cast<int32_t>(drafts.size()); ++other) {
        const uint32_t away = steps[drafts[other].bone];
        if (!isBelow(drafts, other, root) || (best.body >= 0 && away > best.steps)) continue;
        const Contact contact = contactOf(drafts[body].particles, drafts[other].particles, voxels);
        if (best.body < 0 || away < best.steps || contact.distance < best.contact.distance)
            best = {other, away, contact};
    }
    return best;
}

// The body whose particles are at the bone's head; none where no body is that near.
int32_t bodyAtHead(const std::vector<BodyDraft>& drafts, int32_t body, int32_t root, const Voxels& voxels)
{
    float nearest = TOUCH * voxels.diameter;
    int32_t best = -1;
    for (int32_t other = 0; other < static_cast<int32_t>(drafts.size()); ++other) {
        if (!isBelow(drafts, other, root)) continue;
        const float distance = distanceTo(drafts[body].anchor, drafts[other].particles, voxels);
        if (distance < nearest) best = other;
        nearest = std::min(nearest, distance);
    }
    return best;
}

// Joins the trees of a skeleton with several roots: always the root next that is nearest to the main tree.
void joinRoots(std::vector<BodyDraft>& drafts, int32_t root, const BoneTree& tree, const Voxels& voxels,
               std::vector<std::string>& notes)
{
    while (true) {
        Candidate best;
        int32_t child = -1;
        for (int32_t b = 0; b < static_cast<int32_t>(drafts.size()); ++b) {
            if (b == root || drafts[b].parent >= 0) continue;
            const Candidate found = nearestInSkeleton(drafts, b, root, tree, voxels);
            const bool nearer = found.steps < best.steps ||
                                (found.steps == best.steps && found.contact.distance < best.contact.distance);
            if (child >= 0 && !nearer) continue;
            best = found;
            child = b;
        }
        if (child < 0) return;
        // Of the main tree, which it is no part of yet.
        const bool apart = best.contact.distance > LOOSE * voxels.diameter;
        const int32_t atHead = apart ? bodyAtHead(drafts, child, root, voxels) : -1;
        drafts[child].parent = atHead >= 0 ? atHead : best.body;
        const char* why = atHead >= 0              ? "where its head is"
                          : best.steps == NO_INDEX ? "the body nearest to it"
                                                   : "next to it in the skeleton";
        notes.push_back(
            fmt::format("{} is joined to {}, {}.", drafts[child].name, drafts[drafts[child].parent].name, why));
    }
}

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
    const int32_t root = mainRoot(drafts, anatomy);
    joinRoots(drafts, root, tree, voxels, notes);
    tightenJoints(drafts, root, voxels, notes);
    drafts = parentsFirst(std::move(drafts));
}

}  // namespace knuckle
