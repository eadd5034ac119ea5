#include "sim/rig/anatomy/anatomy.h"

#include <algorithm>

#include "sim/rig/anatomy/bone_roles.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/clip_hinges.h"
#include "sim/rig/anatomy/facing.h"
#include "sim/rig/anatomy/names/bone_name.h"
#include "sim/rig/anatomy/shape/shape_fill.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float UPRIGHT = 0.7f;  // the least height of a trunk, over its length
constexpr float APART = 1e-3f;   // two bones at least this far apart are not the same twice [m]

/// Where the limbs of a part begin.
std::vector<Vector3f> placesOf(const Model& model, std::span<const BoneAnatomy> anatomy, BodyPart part)
{
    std::vector<Vector3f> places;
    for (size_t b = 0; b < anatomy.size(); ++b) {
        if (anatomy[b].role != BoneRole::Limb || anatomy[b].part != part) continue;
        const Vector3f head = headIn(model.bones[b].restPose);
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

/// From the right limbs of a part to its left ones, level and unit; 0 if their numbers differ.
Vector3f acrossPart(const Model& model, std::span<const BoneAnatomy> anatomy, BodyPart part)
{
    Vector3f across = Vector3f::Zero();
    int lefts = 0, rights = 0;
    for (uint32_t b = 0; b < anatomy.size(); ++b) {
        const BoneAnatomy& bone = anatomy[b];
        if (bone.role != BoneRole::Limb || bone.part != part || bone.side == 0) continue;
        across += static_cast<float>(bone.side) * boneHead(model, b);
        ++(bone.side > 0 ? lefts : rights);
    }
    across.y() = 0.0f;
    const bool known = lefts == rights && lefts > 0 && across.norm() > APART * static_cast<float>(lefts);
    return known ? Vector3f(across.normalized()) : Vector3f(Vector3f::Zero());
}

}  // namespace

std::vector<BoneAnatomy> readAnatomy(const Model& model, const std::map<uint32_t, BoneRole>& roles)
{
    const BoneTree tree(model);
    std::vector<BoneName> names;
    for (const Bone& bone : model.bones) names.push_back(readBoneName(bone.name));
    std::vector<BoneAnatomy> anatomy = readParts(tree, names);
    readRoles(tree, names, roles, anatomy);
    settleSides(model, anatomy);
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
    using enum BodyPart;
    Vector3f left = acrossPart(model, anatomy, Thigh) + acrossPart(model, anatomy, UpperArm);
    for (const BodyPart part : {Clavicle, Shin, Forearm, Foot, Hand, Coxa, Wing, Toe, Finger, Other})
        if (left.norm() < APART) left = acrossPart(model, anatomy, part);
    return left.norm() < APART ? Vector3f::UnitX() : Vector3f(left.normalized());
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
