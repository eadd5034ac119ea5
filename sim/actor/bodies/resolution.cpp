#include "sim/actor/bodies/resolution.h"

#include <algorithm>
#include <array>
#include <span>

#include "sim/actor/anatomy/anatomy.h"
#include "sim/actor/bodies/bone_bodies.h"

namespace knuckle {

namespace {

constexpr float ACROSS = 2.5f;       // particles, of the thinnest limb
constexpr float MIDDLE_PART = 0.3f;  // of a bone's length on each side of its middle that is looked at
constexpr float SHORTEST = 0.05f;    // of the model's size: a limb; fingers are shorter
constexpr float SLENDER = 1.0f;      // at least so long beside its thickness

/// The limb whose head ends a bone: the farthest of those that hang on it; -1 where none does.
int32_t endOf(const Model& model, std::span<const BoneAnatomy> anatomy, uint32_t bone)
{
    int32_t end = -1;
    float farthest = 0.0f;
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        const float length = (boneHead(model, b) - boneHead(model, bone)).norm();
        if (anatomy[b].parent != static_cast<int32_t>(bone) || length <= farthest) continue;
        farthest = length;
        end = static_cast<int32_t>(b);
    }
    return end;
}

/// The limb of the bone that weighs most at each triangle, or none.
std::vector<uint32_t> triangleLimbs(const Model& model, std::span<const BoneAnatomy> anatomy)
{
    std::vector<uint32_t> limbs;
    for (const auto& triangle : model.triangles) {
        std::array<std::pair<float, uint32_t>, 3> heaviest;
        for (size_t c = 0; c < 3; ++c) {
            const SkinWeights& skin = model.skin[triangle[c]];
            const auto most = std::max_element(skin.weights.begin(), skin.weights.end());
            heaviest[c] = {*most, skin.bones[static_cast<size_t>(most - skin.weights.begin())]};
        }
        limbs.push_back(anatomy[std::max_element(heaviest.begin(), heaviest.end())->second].owner);
    }
    return limbs;
}

struct Patch {
    Vector3f across;  // from the bone's line [m]
    float area;
};

/// Twice the mean distance from the middle of what lies around a bone [m]; 0 where nothing does.
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

bool isLongLimb(BodyPart part)
{
    return part == BodyPart::UpperArm || part == BodyPart::Forearm || part == BodyPart::Thigh || part == BodyPart::Shin;
}

}  // namespace

std::vector<LimbThickness> limbThicknesses(const Model& model)
{
    if (model.skin.size() != model.vertices.size() || model.bones.empty()) return {};
    const std::vector<BoneAnatomy> anatomy = readAnatomy(model);
    const std::vector<uint32_t> owners = triangleLimbs(model, anatomy);
    std::vector<std::vector<uint32_t>> owned(model.bones.size());
    for (uint32_t t = 0; t < owners.size(); ++t)
        if (owners[t] != NO_INDEX) owned[owners[t]].push_back(t);
    Eigen::AlignedBox3f bounds;
    for (const Vector3f& vertex : model.vertices) bounds.extend(vertex);
    const float size = bounds.sizes().maxCoeff();
    std::vector<LimbThickness> known, others;
    for (uint32_t bone = 0; bone < model.bones.size(); ++bone) {
        const int32_t end = endOf(model, anatomy, bone);
        if (end < 0) continue;
        const Vector3f head = boneHead(model, bone), along = boneHead(model, static_cast<uint32_t>(end)) - head;
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
        if (isLongLimb(anatomy[bone].part)) known.push_back(limb);
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
