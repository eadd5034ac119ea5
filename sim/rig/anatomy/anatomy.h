#pragma once

#include <map>
#include <span>
#include <vector>

#include "sim/rig/model.h"
#include "sim/world/world.h"

namespace knuckle {

/// The part of a body that a bone is.
enum class BodyPart {
    Other,
    Hips,
    Spine,
    Neck,
    Head,
    Clavicle,
    UpperArm,
    Forearm,
    Hand,
    Finger,
    Thigh,
    Shin,
    Foot,
    Toe,
    Tail,
    Wing,
    Coxa,   ///< Between a creature's trunk and its thigh.
    Lever,  ///< Of a machine.
};

/// How a bone's part is known.
enum class AnatomySource {
    None,
    Name,   ///< The bone's, and those around it.
    Shape,  ///< Of the skeleton: what hangs where, and which bones mirror each other.
    Clip,   ///< The bone only ever turns about one axis.
};

enum class BoneRole {
    Limb,      ///< Has a body if it is large enough.
    Twist,     ///< Takes a share of a limb's turn, or is another piece of the limb: part of that limb's body.
    Attached,  ///< Face, hair, clothes, props: part of the body that it hangs on.
    Control,   ///< Deforms nothing: targets, poles, scene roots.
};

struct BoneAnatomy {
    BodyPart part = BodyPart::Other;
    int side = 0;  ///< +1 left, -1 right, 0 neither.
    AnatomySource source = AnatomySource::None;
    BoneRole role = BoneRole::Limb;
    uint32_t owner = NO_INDEX;      ///< The limb to whose body it belongs; for a limb, itself.
    int32_t parent = -1;            ///< For a limb, the one that it hangs on; -1 for a first one.
    Eigen::Vector3f axis{0, 0, 0};  ///< If known by Clip, the axis of its hinge, unit, at rest; else 0.
};

/// Reads names in the conventions of Mixamo, Biped, Rigify, MakeHuman, VRM, Unreal, Source, SMPL, Daz, Roblox, CMU,
/// Character Creator, MikuMikuDance, Maya and Second Life; if a word means several things, the bones around it decide.
/// The skeleton's shape completes limbs that names leave open, if it agrees with the names: two chains down to the
/// ground are legs, two above arms, the single one upwards neck and head; more legs make a creature. Of four legs the
/// front ones are its arms. Limbs whose bones hang on none with skin hang on the part of the trunk that carries such
/// limbs.
/// @param roles of bones, by index, which override names.
/// @returns one entry a bone. Following parents ends at a bone without one, never in a ring.
std::vector<BoneAnatomy> readAnatomy(const Model& model, const std::map<uint32_t, BoneRole>& roles = {});

/// The joint at the head of such a bone: knees, elbows, fingers, toes and levers are hinges, spine, neck and collar
/// bones are stiff, everything else is a ball.
JointType jointTypeOf(BodyPart part);

/// Whether it stands on two legs, its trunk above them. False for more legs, or a level trunk.
bool isUpright(const Model& model, std::span<const BoneAnatomy> anatomy);

/// Upper arms, forearms, thighs and shins.
bool isLongLimb(BodyPart part);

/// A figure's left, level and unit, from where its thighs and upper arms begin, however these are posed; without them,
/// from its other limbs that exist on both sides; x if there are none.
Eigen::Vector3f leftOf(const Model& model, std::span<const BoneAnatomy> anatomy);

}  // namespace knuckle
