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

/// The axes, and from each bone to what hangs on the same one.
std::vector<Vector3f> guesses(const BoneTree& tree, float size)
{
    std::vector<Vector3f> directions{Vector3f::UnitX(), Vector3f::UnitZ()};
    for (const std::vector<uint32_t>& siblings : tree.children) {
        for (size_t i = 0; i < siblings.size(); ++i) {
            for (size_t j = i + 1; j < siblings.size() && directions.size() < MOST_GUESSES; ++j) {
                Vector3f way = tree.heads[siblings[j]] - tree.heads[siblings[i]];
                way.y() = 0.0f;
                if (way.norm() > BESIDE * size) directions.push_back(way.normalized());
            }
        }
    }
    return directions;
}

}  // namespace

float sizeOf(const BoneTree& tree)
{
    Eigen::AlignedBox3f box;
    for (uint32_t b = 0; b < tree.size(); ++b)
        if (tree.carries[b]) box.extend(tree.heads[b]);
    return box.isEmpty() ? 0.0f : box.sizes().maxCoeff();
}

std::optional<MirrorPlane> findMirrorPlane(const BoneTree& tree)
{
    const float size = sizeOf(tree);
    if (size <= 0.0f) return {};
    const std::vector<uint32_t> depths = tree.depths();
    Vector3f middle = Vector3f::Zero();
    float count = 0.0f;
    for (uint32_t b = 0; b < tree.size(); ++b) {
        if (!tree.carries[b]) continue;
        middle += tree.heads[b];
        count += 1.0f;
    }
    MirrorPlane best;
    uint32_t most = 0;
    for (const Vector3f& across : guesses(tree, size)) {
        const MirrorPlane plane{across, across.dot(middle) / count};
        const uint32_t images = imagesIn(tree, depths, plane, size);
        if (images <= most) continue;
        most = images;
        best = plane;
    }
    return most < FEWEST_IMAGES ? std::nullopt : std::optional(best);
}

}  // namespace knuckle
