#include "sim/rig/import/skeleton/skeleton_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "sim/base/lowercase.h"
#include "sim/rig/anatomy/bone_tree.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr int SIDES = 8;             // around a capsule
constexpr int CAP_RINGS = 2;         // of each of its ends
constexpr float SAME_PLACE = 1e-3f;  // of the figure's size
constexpr float THICK_PART = 0.5f;   // a capsule, except the skull, is no thicker than this share of its length ...
constexpr float SIDEWAYS = 0.5f;     // cosine between skull and neck, below which the skull lies on its side
constexpr float THINNEST = 0.012f;   // ... unless that would be thinner than this share of the figure's size

// Lengths of an adult's ends, if no bone gives them [of the figure's size].
constexpr float HEAD_LENGTH = 0.09f, HAND_LENGTH = 0.08f, FOOT_LENGTH = 0.09f, FOOT_DROP = 0.02f;
// Words in names of bones that are ends themselves.
constexpr std::array END_WORDS{"end", "nub", "site", "tip"};

struct Thickness {
    const char* word;
    float radius;  // of the figure's size
};

// The first word found in the lower-case name counts. Radii of an adult.
constexpr Thickness THICKNESSES[] = {
    {"thumb", 0.008f},  {"index", 0.008f},    {"middle", 0.008f}, {"ring", 0.008f},    {"pinky", 0.008f},
    {"finger", 0.012f}, {"hand", 0.022f},     {"wrist", 0.022f},  {"forearm", 0.024f}, {"elbow", 0.024f},
    {"collar", 0.035f}, {"clavicle", 0.035f}, {"arm", 0.03f},     {"shoulder", 0.03f}, {"toe", 0.018f},
    {"foot", 0.024f},   {"ankle", 0.024f},    {"upleg", 0.045f},  {"thigh", 0.045f},   {"knee", 0.033f},
    {"shin", 0.033f},   {"calf", 0.033f},     {"leg", 0.035f},    {"hipjoint", 0.05f}, {"hips", 0.06f},
    {"hip", 0.045f},    {"neck", 0.032f},     {"head", 0.05f},    {"spine", 0.06f},    {"chest", 0.065f},
    {"back", 0.06f},    {"torso", 0.065f},    {"abdomen", 0.06f}, {"pelvis", 0.06f},   {"body", 0.06f},
};
constexpr float USUAL_THICKNESS = 0.03f;

Vector3f sizeOf(const Model& model)
{
    Vector3f low = boneHead(model, 0), high = low;
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        low = low.cwiseMin(boneHead(model, b));
        high = high.cwiseMax(boneHead(model, b));
    }
    return high - low;
}

float radiusFor(const std::string& name, float length, float size)
{
    const std::string lower = lowercase(name);
    float part = USUAL_THICKNESS;
    for (const Thickness& thickness : THICKNESSES) {
        if (lower.find(thickness.word) != std::string::npos) {
            part = thickness.radius;
            break;
        }
    }
    const bool skull = lower.find("head") != std::string::npos;
    return skull ? part * size : std::min(part * size, std::max(THICK_PART * length, THINNEST * size));
}

// Rings from the tip of one cap to the tip of the other; the tips are single vertices.
void addCapsule(Model& model, const Vector3f& a, const Vector3f& b, float radius, uint32_t bone)
{
    const Vector3f axis = (b - a).normalized(), u = axis.unitOrthogonal(), v = axis.cross(u);
    const uint32_t first = static_cast<uint32_t>(model.vertices.size());
    constexpr int RINGS = 2 * CAP_RINGS;
    const auto add = [&](const Vector3f& p) {
        SkinWeights skin;
        skin.bones[0] = bone;
        skin.weights[0] = 1.0f;
        model.vertices.push_back(p);
        model.skin.push_back(skin);
    };
    add(a - radius * axis);
    for (int r = 0; r < RINGS; ++r) {
        const int step = r < CAP_RINGS ? r + 1 - CAP_RINGS : r - CAP_RINGS;
        const float tilt = 0.5f * std::numbers::pi_v<float> * static_cast<float>(step) / CAP_RINGS;
        const Vector3f centre = (r < CAP_RINGS ? a : b) + radius * std::sin(tilt) * axis;
        for (int s = 0; s < SIDES; ++s) {
            const float turn = 2.0f * std::numbers::pi_v<float> * static_cast<float>(s) / SIDES;
            add(centre + radius * std::cos(tilt) * (std::cos(turn) * u + std::sin(turn) * v));
        }
    }
    add(b + radius * axis);
    const uint32_t last = static_cast<uint32_t>(model.vertices.size() - 1);
    const auto at = [&](int ring, int side) { return first + 1 + static_cast<uint32_t>(ring * SIDES + side % SIDES); };
    for (int s = 0; s < SIDES; ++s) {
        model.triangles.push_back({first, at(0, s + 1), at(0, s)});
        for (int r = 0; r + 1 < RINGS; ++r) {
            model.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1)});
            model.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r + 1, s)});
        }
        model.triangles.push_back({last, at(RINGS - 1, s), at(RINGS - 1, s + 1)});
    }
}

/// Bones between a scene's root and the figure: a chain from a root to the first bone that branches, such as a
/// trajectory on the ground and the way up to the hips, and anything else that the hips hang on. They include no part
/// of a body.
std::vector<uint8_t> columnsOf(const BoneTree& tree, const std::vector<BoneAnatomy>& anatomy)
{
    std::vector<uint8_t> columns(tree.size(), 0);
    for (uint32_t root = 0; root < tree.size(); ++root) {
        if (tree.parents[root] >= 0) continue;
        std::vector<uint32_t> chain;
        uint32_t bone = root;
        const auto isPart = [&] {
            return anatomy[bone].part != BodyPart::Other && anatomy[bone].part != BodyPart::Hips;
        };
        for (; tree.children[bone].size() == 1 && !isPart(); bone = tree.children[bone].front()) chain.push_back(bone);
        if (tree.children[bone].size() < 2) continue;
        for (const uint32_t above : chain) columns[above] = 1;
    }
    // Controls may hang beside the hips.
    if (std::ranges::count(anatomy, BodyPart::Hips, &BoneAnatomy::part) == 1) {
        const auto hips = std::ranges::find(anatomy, BodyPart::Hips, &BoneAnatomy::part) - anatomy.begin();
        for (int32_t b = tree.parents[static_cast<size_t>(hips)]; b >= 0; b = tree.parents[b]) columns[b] = 1;
    }
    return columns;
}

/// The end of a head, hand or foot without a bone that marks it.
std::optional<Vector3f> unsaidEnd(const Model& model, const BoneTree& tree, const BoneAnatomy& anatomy, uint32_t bone,
                                  const Vector3f& forward, float size)
{
    const std::string name = lowercase(model.bones[bone].name);
    const bool isEnd = std::ranges::any_of(END_WORDS, [&](const char* w) { return name.find(w) != std::string::npos; });
    if (!tree.children[bone].empty() || tree.parents[bone] < 0 || isEnd) return {};
    const Vector3f head = boneHead(model, bone);
    const Vector3f from = head - boneHead(model, static_cast<uint32_t>(tree.parents[bone]));
    if (from.norm() < SAME_PLACE * size) return {};
    const Vector3f along = from.normalized();
    switch (anatomy.part) {
        case BodyPart::Head: return head + HEAD_LENGTH * size * along;
        case BodyPart::Hand: return head + HAND_LENGTH * size * along;
        case BodyPart::Foot: return head + size * (FOOT_LENGTH * forward - FOOT_DROP * Vector3f::UnitY());
        default: return {};
    }
}

/// The end of the capsule towards a bone's child: the child, except for a skull that the file lays on its side, as some
/// recorders do; such a skull continues in the direction of the neck.
Vector3f capsuleEnd(const Model& model, const BoneTree& tree, const std::vector<BoneAnatomy>& anatomy, uint32_t child)
{
    const uint32_t bone = static_cast<uint32_t>(tree.parents[child]);
    const int32_t neck = tree.parents[bone];
    Vector3f to = boneHead(model, child);
    const Vector3f from = boneHead(model, bone);
    if (anatomy[bone].part != BodyPart::Head || neck < 0 || !tree.children[child].empty()) return to;
    const Vector3f before = from - boneHead(model, static_cast<uint32_t>(neck));
    const float length = (to - from).norm();
    return before.dot(to - from) < SIDEWAYS * before.norm() * length ? Vector3f(from + length * before.normalized())
                                                                     : to;
}

}  // namespace

void addBodyAlongBones(Model& model, const std::vector<BoneAnatomy>& anatomy)
{
    if (model.bones.size() < 2) {
        return;
    }
    const BoneTree tree(model);
    const std::vector<uint8_t> columns = columnsOf(tree, anatomy);
    const float size = sizeOf(model).maxCoeff();
    std::vector<uint32_t> carrier(model.bones.size());
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        const int32_t parent = model.bones[b].parent;
        carrier[b] = b;
        if (parent < 0 || columns[parent] != 0) {
            continue;
        }
        const Vector3f from = boneHead(model, static_cast<uint32_t>(parent)), to = capsuleEnd(model, tree, anatomy, b);
        const float length = (to - from).norm();
        if (length < SAME_PLACE * size) {
            carrier[b] = carrier[parent];
        } else {
            addCapsule(model, from, to, radiusFor(model.bones[parent].name, length, size), carrier[parent]);
        }
    }
    const Vector3f forward = leftOf(model, anatomy).cross(Vector3f::UnitY());
    for (uint32_t b = 0; b < model.bones.size(); ++b)
        if (const auto end = unsaidEnd(model, tree, anatomy[b], b, forward, size))
            addCapsule(model, boneHead(model, b), *end,
                       radiusFor(model.bones[b].name, (*end - boneHead(model, b)).norm(), size), carrier[b]);
    model.notes.push_back("The file has a skeleton and no mesh: a body was made of capsules along its bones.");
}

}  // namespace knuckle
