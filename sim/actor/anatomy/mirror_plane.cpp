#include "sim/actor/anatomy/mirror_plane.h"

#include <algorithm>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float SAME_PLACE = 0.05f;    // a bone's mirror image is this near to another bone [size]
constexpr float BESIDE = 0.01f;        // what is farther from the plane lies to a side of it [size]
constexpr size_t MOST_GUESSES = 24;    // directions that are tried
constexpr uint32_t FEWEST_IMAGES = 4;  // bones beside the plane that have an image

/// Bones beside the plane whose image is another bone, as far from the root: a hind leg is none of a front leg.
uint32_t imagesIn(const BoneTree& tree, const std::vector<uint32_t>& depths, const MirrorPlane& plane, float size)
{
    uint32_t images = 0;
    for (uint32_t b = 0; b < tree.size(); ++b) {
        if (!tree.carries[b] || std::abs(plane.distance(tree.heads[b])) < BESIDE * size) continue;
        const Vector3f image = plane.mirrored(tree.heads[b]);
        bool found = false;
        for (uint32_t other = 0; other < tree.size() && !found; ++other)
            found = other != b && depths[other] == depths[b] && tree.carries[other] &&
                    (tree.heads[other] - image).norm() < SAME_PLACE * size;
        images += found;
    }
    return images;
}

bool hasSkin(const BoneTree& tree, uint32_t b)
{
    return tree.carries[b] && tree.deforms[b];
}

Vector3f middleOf(const BoneTree& tree)
{
    Vector3f sum = Vector3f::Zero();
    float count = 0.0f;
    for (uint32_t b = 0; b < tree.size(); ++b) {
        if (!hasSkin(tree, b)) continue;
        sum += tree.heads[b];
        count += 1.0f;
    }
    return sum / std::max(count, 1.0f);
}

/// Through the middle of all bones, across the axes and ways between bones on the same one; then halfway between these.
std::vector<MirrorPlane> guesses(const BoneTree& tree, const Vector3f& middle, float size)
{
    std::vector<MirrorPlane> planes{{Vector3f::UnitX(), middle.x()}, {Vector3f::UnitZ(), middle.z()}};
    std::vector<MirrorPlane> between;
    for (const std::vector<uint32_t>& siblings : tree.children) {
        for (size_t i = 0; i < siblings.size(); ++i) {
            for (size_t j = i + 1; j < siblings.size() && planes.size() < MOST_GUESSES; ++j) {
                const Vector3f &from = tree.heads[siblings[i]], &to = tree.heads[siblings[j]];
                Vector3f way = to - from;
                way.y() = 0.0f;
                if (way.norm() < BESIDE * size) continue;
                way.normalize();
                planes.push_back({way, way.dot(middle)});
                between.push_back({way, 0.5f * way.dot(from + to)});
            }
        }
    }
    planes.insert(planes.end(), between.begin(), between.end());
    return planes;
}

}  // namespace

float sizeOf(const BoneTree& tree)
{
    Eigen::AlignedBox3f box;
    for (uint32_t b = 0; b < tree.size(); ++b)
        if (hasSkin(tree, b)) box.extend(tree.heads[b]);
    return box.isEmpty() ? 0.0f : box.sizes().maxCoeff();
}

std::optional<MirrorPlane> findMirrorPlane(const BoneTree& tree)
{
    const float size = sizeOf(tree);
    if (size <= 0.0f) return {};
    const std::vector<uint32_t> depths = tree.depths();
    const Vector3f middle = middleOf(tree);
    MirrorPlane best;
    uint32_t most = 0;
    for (const MirrorPlane& plane : guesses(tree, middle, size)) {
        const uint32_t images = imagesIn(tree, depths, plane, size);
        // One off the middle, where much is on one side alone, has to be better by far.
        const bool central = std::abs(plane.distance(middle)) < BESIDE * size;
        if (images <= most || (!central && images < most + FEWEST_IMAGES)) continue;
        most = images;
        best = plane;
    }
    return most < FEWEST_IMAGES ? std::nullopt : std::optional(best);
}

}  // namespace knuckle
