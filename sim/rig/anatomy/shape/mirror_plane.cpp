#include "sim/rig/anatomy/shape/mirror_plane.h"

#include <algorithm>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float SAME_PLACE = 0.05f;   // a bone's mirror image is this near to another bone [size]
constexpr float BESIDE = 0.01f;       // bones further from the plane lie to a side of it [size]
constexpr size_t MOST_GUESSES = 24;   // directions to try
constexpr int32_t FEWEST_IMAGES = 4;  // bones beside the plane that have an image

/// How many bones beside a plane have an image, and how many have none.
struct Images {
    int32_t found = 0, missing = 0;
};

/// A bone's image is another bone, as far from the root and of the other side: a hind leg is not one of a front leg.
Images imagesIn(const BoneTree& tree, const std::vector<uint32_t>& depths, const MirrorPlane& plane, float size)
{
    Images images;
    for (uint32_t b = 0; b < tree.size(); ++b) {
        if (!tree.carries[b] || std::abs(plane.distance(tree.heads[b])) < BESIDE * size) continue;
        const Vector3f image = plane.mirrored(tree.heads[b]);
        bool found = false;
        for (uint32_t other = 0; other < tree.size() && !found; ++other)
            found = other != b && tree.sides[other] == -tree.sides[b] && depths[other] == depths[b] &&
                    tree.carries[other] && (tree.heads[other] - image).norm() < SAME_PLACE * size;
        ++(found ? images.found : images.missing);
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

/// Planes through the middle of all bones, across the axes and lines between siblings; then planes halfway between
/// siblings.
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
    int32_t most = 0, images = 0;
    for (const MirrorPlane& plane : guesses(tree, middle, size)) {
        const auto [found, missing] = imagesIn(tree, depths, plane, size);
        // A plane off the middle, as with much on one side alone, has to be much better.
        const bool central = std::abs(plane.distance(middle)) < BESIDE * size;
        const int32_t counts = found - missing;
        if ((images > 0 && counts <= most) || (!central && counts < most + 2 * FEWEST_IMAGES)) continue;
        most = counts;
        images = found;
        best = plane;
    }
    return images < FEWEST_IMAGES ? std::nullopt : std::optional(best);
}

}  // namespace knuckle
