#include "sim/rig/bodies/resolution.h"

#include <algorithm>
#include <array>
#include <span>

#include "sim/rig/limbs/limb_owner.h"

namespace knuckle {

namespace {

constexpr float ACROSS = 2.5f;       // particles, of the thinnest limb
constexpr float MIDDLE_PART = 0.3f;  // of a bone's length: the range on each side of its middle that is measured
constexpr float SHORTEST = 0.05f;    // of the model's size: the shortest limb; fingers are shorter
constexpr float SLENDER = 1.0f;      // least length over thickness

struct Patch {
    Vector3f across;  // from the bone's line [m]
    float area;
};

/// Twice the mean distance from the middle of the surface around a bone [m]; 0 if there is none.
float thicknessOf(const std::vector<Patch>& patches)
{
    Vector3f middle = Vector3f::Zero();
    float area = 0.0f, distance = 0.0f;
    for (const Patch& patch : patches) {
        middle += patch.area * patch.across;
        area += patch.area;
    }
    if (!(area > 0.0f)) return 0.0f;
    middle /= area;
    for (const Patch& patch : patches) distance += patch.area * (patch.across - middle).norm();
    return 2.0f * distance / area;
}

}  // namespace

std::vector<LimbThickness> limbThicknesses(const Figure& figure)
{
    const Model& model = figure.model;
    if (!figure.hasSkin() || model.isSplit) return {};
    LimbOwner owner(figure);
    std::vector<std::vector<uint32_t>> owned(model.bones.size());
    for (uint32_t t = 0; t < model.triangles.size(); ++t) owned[owner.atMiddleOf(t)].push_back(t);
    Eigen::AlignedBox3f bounds;
    for (const Vector3f& vertex : model.vertices) bounds.extend(vertex);
    const float size = bounds.sizes().maxCoeff();
    std::vector<LimbThickness> known, others;
    for (uint32_t bone = 0; bone < model.bones.size(); ++bone) {
        const std::optional<Vector3f> end = limbEnd(figure, bone);
        if (!end) continue;
        const Vector3f head = boneHead(model, bone), along = *end - head;
        const float length = along.norm();
        std::vector<Patch> patches;
        for (const uint32_t t : owned[bone]) {
            const auto& [a, b, c] = model.triangles[t];
            const Vector3f &p = model.vertices[a], &q = model.vertices[b], &r = model.vertices[c];
            const Vector3f from = (p + q + r) / 3.0f - head;
            const float way = from.dot(along) / (length * length);
            if (std::abs(way - 0.5f) <= MIDDLE_PART)
                patches.push_back({from - way * along, 0.5f * (q - p).cross(r - p).norm()});
        }
        const LimbThickness limb{bone, thicknessOf(patches), length};
        if (limb.thickness == 0.0f) continue;
        if (isLongLimb(figure.anatomy[bone].part)) known.push_back(limb);
        else if (length > SHORTEST * size && length > SLENDER * limb.thickness) others.push_back(limb);
    }
    return known.empty() ? others : known;
}

float limbDiameter(std::span<const LimbThickness> limbs)
{
    const auto thinnest = std::ranges::min_element(limbs, {}, &LimbThickness::thickness);
    return thinnest == limbs.end() ? 0.0f : thinnest->thickness / ACROSS;
}

}  // namespace knuckle
