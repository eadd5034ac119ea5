#include "sim/actor/bodies/body_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float TOUCH = 1.8f;        // lattice neighbours, diagonals included, are nearer than this [d]
constexpr float LOOSE = 2.6f;        // bodies farther apart than this are looked at again [d]
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

// The parentless body that most particles hang from.
int32_t mainRoot(const std::vector<BodyDraft>& drafts)
{
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

// Joins the trees of a skeleton with several roots: always the root next that is nearest to the main tree.
void joinRoots(std::vector<BodyDraft>& drafts, int32_t root, const Voxels& voxels, std::vector<std::string>& notes)
{
    while (true) {
        Contact best;
        int32_t child = -1, parent = -1;
        for (int32_t b = 0; b < static_cast<int32_t>(drafts.size()); ++b) {
            for (int32_t other = 0; b != root && drafts[b].parent < 0 && other < static_cast<int32_t>(drafts.size());
                 ++other) {
                if (!isBelow(drafts, other, root)) {
                    continue;
                }
                const Contact contact = contactOf(drafts[b].particles, drafts[other].particles, voxels);
                if (contact.distance < best.distance) {
                    best = contact;
                    child = b;
                    parent = other;
                }
            }
        }
        if (child < 0) {
            return;
        }
        drafts[child].parent = parent;
        notes.push_back(
            fmt::format("{} is joined to {}, the body nearest to it.", drafts[child].name, drafts[parent].name));
        if (distanceTo(drafts[child].anchor, drafts[parent].particles, voxels) > NEAR_JOINT * voxels.diameter ||
            distanceTo(drafts[child].anchor, drafts[child].particles, voxels) > NEAR_JOINT * voxels.diameter) {
            drafts[child].anchor = best.middle;
        }
    }
}

// Bodies that stand apart from their parent but touch another (feet that hang from an inverse-kinematics control)
// join that; joints move to where the bodies meet if the bone's head is away from there.
void tightenJoints(std::vector<BodyDraft>& drafts, int32_t root, const Voxels& voxels, std::vector<std::string>& notes)
{
    const float d = voxels.diameter;
    for (int32_t b = 0; b < static_cast<int32_t>(drafts.size()); ++b) {
        BodyDraft& body = drafts[b];
        if (b == root) {
            continue;
        }
        const Contact kept = contactOf(body.particles, drafts[body.parent].particles, voxels);
        Contact best = kept;
        int32_t better = body.parent;
        for (int32_t other = 0; kept.distance > LOOSE * d && other < static_cast<int32_t>(drafts.size()); ++other) {
            if (isBelow(drafts, other, b)) {
                continue;
            }
            const Contact contact = contactOf(body.particles, drafts[other].particles, voxels);
            if (contact.distance < std::min(best.distance, 0.5f * kept.distance)) {
                best = contact;
                better = other;
            }
        }
        const float offBody = distanceTo(body.anchor, body.particles, voxels);
        const float offParent = distanceTo(body.anchor, drafts[better].particles, voxels);
        if (better != body.parent) {
            notes.push_back(fmt::format("{} is joined to {}, which it touches, instead of {}.", body.name,
                                        drafts[better].name, drafts[body.parent].name));
            body.parent = better;
            body.anchor = best.middle;
        } else if (offBody > NEAR_JOINT * d || (offParent > NEAR_JOINT * d && best.distance < TOUCH * d)) {
            notes.push_back(
                fmt::format("The joint of {} sits where it meets {}, since the bone's head is away from it.", body.name,
                            drafts[better].name));
            body.anchor = best.middle;
        }
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

void arrangeTree(std::vector<BodyDraft>& drafts, const Voxels& voxels, std::vector<std::string>& notes)
{
    const int32_t root = mainRoot(drafts);
    joinRoots(drafts, root, voxels, notes);
    tightenJoints(drafts, root, voxels, notes);
    drafts = parentsFirst(std::move(drafts));
}

}  // namespace knuckle
