#include "sim/rig/anatomy/shape/mirror.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float SAME_PLACE = 0.02f;  // of the skeleton's size: a bone's image and the bone there
constexpr float LEVEL = 0.9999f;     // cosine of a plane's normal with an axis

std::vector<uint32_t> nearestImages(const BoneTree& tree, const MirrorPlane& plane)
{
    const float reach = SAME_PLACE * sizeOf(tree);
    std::vector<uint32_t> images(tree.size(), NO_INDEX);
    const std::vector<uint32_t> depths = tree.depths();
    for (uint32_t b = 0; b < tree.size(); ++b) {
        const Vector3f image = plane.mirrored(tree.heads[b]);
        float nearest = reach;
        for (uint32_t other = 0; other < tree.size(); ++other) {
            // Of bones at one place, the image is the one as far from the root, and a bone prefers itself.
            const float distance = (tree.heads[other] - image).norm();
            if (depths[other] != depths[b] || !(distance < nearest || (other == b && distance <= nearest))) continue;
            nearest = distance;
            images[b] = other;
        }
    }
    return images;
}

}  // namespace

int Mirror::axis() const
{
    Vector3f::Index axis = 0;
    return plane.across.cwiseAbs().maxCoeff(&axis) > LEVEL ? static_cast<int>(axis) : -1;
}

void Mirror::keepAlike(std::span<const BoneAnatomy> anatomy)
{
    std::vector<uint32_t> unlike;
    for (uint32_t b = 0; b < images.size(); ++b) {
        const uint32_t image = images[b], owner = anatomy[b].owner;
        if (image == NO_INDEX || images[owner] == anatomy[image].owner) continue;
        for (const uint32_t bone : {b, image, owner, anatomy[image].owner})
            if (images[bone] != bone) unlike.push_back(bone);
    }
    for (const uint32_t bone : unlike) images[bone] = NO_INDEX;
}

std::optional<Mirror> findMirror(const BoneTree& tree)
{
    const std::optional<MirrorPlane> plane = findMirrorPlane(tree);
    if (!plane) return {};
    Mirror mirror{*plane, nearestImages(tree, *plane)};
    for (uint32_t b = 0; b < tree.size(); ++b) {
        const uint32_t image = mirror.images[b];
        if (image != NO_INDEX && mirror.images[image] != b) mirror.images[b] = NO_INDEX;
    }
    return mirror;
}

}  // namespace knuckle
