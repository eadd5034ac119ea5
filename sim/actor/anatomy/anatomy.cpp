#include "sim/actor/anatomy/anatomy.h"

#include <algorithm>

#include "sim/actor/anatomy/bone_name.h"
#include "sim/actor/anatomy/bone_roles.h"
#include "sim/actor/anatomy/bone_tree.h"
#include "sim/actor/anatomy/chain_parts.h"
#include "sim/actor/anatomy/clip_hinges.h"
#include "sim/actor/anatomy/shape_parts.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float UPRIGHT = 0.7f;  // a trunk's height is this share of its length at least
constexpr float APART = 1e-3f;   // two bones, not one twice [m]

/// Where limbs of a part begin.
std::vector<Vector3f> placesOf(const Model& model, std::span<const BoneAnatomy> anatomy, BodyPart part)
{
    std::vector<Vector3f> places;
    for (size_t b = 0; b < anatomy.size(); ++b) {
        if (anatomy[b].role != BoneRole::Limb || anatomy[b].part != part) continue;
        const Vector3f head = model.bones[b].restPose.block<3, 1>(0, 3);
        if (std::ranges::none_of(places, [&](const Vector3f& place) { return (place - head).norm() < APART; }))
            places.push_back(head);
    }
    return places;
}

Vector3f meanOf(const std::vector<Vector3f>& places)
{
    Vector3f sum = Vector3f::Zero();
    for (const Vector3f& place : places) sum += place;
    return sum / static_cast<float>(places.size());
}

}  // namespace

std::vector<BoneAnatomy> readAnatomy(const Model& model, const std::map<uint32_t, BoneRole>& roles)
{
    const BoneTree tree(model);
    std::vector<BoneName> names;
    for (const Bone& bone : model.bones) names.push_back(readBoneName(bone.name));
    std::vector<BoneAnatomy> anatomy(model.bones.size());
    readNamedParts(tree, names, anatomy);
    const bool limbsNamed = std::ranges::any_of(anatomy, isLimbPart, &BoneAnatomy::part);
    if (!limbsNamed) readPartsFromShape(tree, anatomy);
    readRoles(tree, names, roles, anatomy);
    readClipHinges(model, anatomy);
    return anatomy;
}

JointType jointTypeOf(BodyPart part)
{
    switch (part) {
        case BodyPart::Forearm:
        case BodyPart::Shin:
        case BodyPart::Toe:
        case BodyPart::Finger:
        case BodyPart::Lever: return JointType::Hinge;
        case BodyPart::Clavicle:
        case BodyPart::Spine:
        case BodyPart::Neck:
        case BodyPart::Hips: return JointType::Stiff;
        default: return JointType::Ball;
    }
}

Vector3f leftOf(const Model& model, std::span<const BoneAnatomy> anatomy)
{
    Vector3f left = Vector3f::Zero(), right = Vector3f::Zero();
    int lefts = 0, rights = 0;
    for (size_t b = 0; b < anatomy.size(); ++b) {
        if (anatomy[b].role == BoneRole::Control) continue;
        const Vector3f head = model.bones[b].restPose.block<3, 1>(0, 3);
        if (anatomy[b].side > 0) left += head;
        if (anatomy[b].side < 0) right += head;
        lefts += anatomy[b].side > 0;
        rights += anatomy[b].side < 0;
    }
    if (lefts == 0 || rights == 0) return Vector3f::UnitX();
    Vector3f across = left / static_cast<float>(lefts) - right / static_cast<float>(rights);
    across.y() = 0.0f;
    return across.norm() > 1e-4f ? Vector3f(across.normalized()) : Vector3f::UnitX();
}

bool isUpright(const Model& model, std::span<const BoneAnatomy> anatomy)
{
    const std::vector<Vector3f> arms = placesOf(model, anatomy, BodyPart::UpperArm),
                                thighs = placesOf(model, anatomy, BodyPart::Thigh);
    if (thighs.size() > 2) return false;
    if (arms.empty() || thighs.empty()) return true;
    const Vector3f trunk = meanOf(arms) - meanOf(thighs);
    return trunk.y() > UPRIGHT * trunk.norm();
}

bool isLongLimb(BodyPart part)
{
    return part == BodyPart::UpperArm || part == BodyPart::Forearm || part == BodyPart::Thigh || part == BodyPart::Shin;
}

}  // namespace knuckle
