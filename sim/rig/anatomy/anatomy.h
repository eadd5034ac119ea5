#pragma once

#include <map>
#include <span>
#include <vector>

#include "sim/rig/model.h"
#include "sim/world/world.h"

namespace knuckle {

/// What of a body a bone is.
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

/// Where a bone's part is known from.
enum class AnatomySource {
    None,
    Name,   ///< The bone's, and those around it.
    Shape,  ///< Of the skeleton: what hangs where, what mirrors what.
    Clip,   ///< The bone only ever turns about one axis.
};

enum class BoneRole {
    Limb,      ///< Has a body where it is large enough.
    Twist,     ///< Takes a share of a limb's turn, or is a further piece of it: part of that limb's body.
    Attached,  ///< Face, hair, clothes, props: part of the body that it hangs on.
    Control,   ///< Deforms nothing: targets, poles, scene roots.
};

struct BoneAnatomy {
    BodyPart part = BodyPart::Other;
    int side = 0;  ///< +1 left, -1 right, 0 neither.
    AnatomySource source = AnatomySource::None;
    BoneRole role = BoneRole::Limb;
    uint32_t owner = NO_INDEX;      ///< The limb whose body it is of; a limb's is itself.
    int32_t parent = -1;            ///< Of a limb, the one that it hangs on; -1 of a first one.
    Eigen::Vector3f axis{0, 0, 0};  ///< By Clip, of its hinge, unit, at rest; else 0.
};

/// Reads names in the conventions of Mixamo, Biped, Rigify, MakeHuman, VRM, Unreal, Source, SMPL, Daz, Roblox, CMU,
/// Character Creator, MikuMikuDance, Maya and Second Life, with the bones around them where a word means several
/// things. What names leave open of limbs the skeleton's shape decides, where it agrees with them: two chains down to
/// the ground are legs, two above arms, the single one up neck and head; more legs make a creature. Of four legs the
/// front ones are its arms. Limbs whose bones hang on none with skin hang on the part of the trunk that carries such.
/// @param roles of bones, by index, that stand whatever names say.
/// @returns one entry a bone. Parents lead to a bone without one, never in a ring.
std::vector<BoneAnatomy> readAnatomy(const Model& model, const std::map<uint32_t, BoneRole>& roles = {});

/// The joint at the head of such a bone: knees, elbows, fingers, toes and levers are hinges, spine, neck and collar
/// bones are stiff, everything else is a ball.
JointType jointTypeOf(BodyPart part);

/// Whether it stands on two legs, its trunk above them. What has more of them, or a level trunk, does not.
bool isUpright(const Model& model, std::span<const BoneAnatomy> anatomy);

/// Upper arms, forearms, thighs and shins.
bool isLongLimb(BodyPart part);

/// A figure's left, level and unit, from where its thighs and upper arms begin, however these are posed; without them
/// from its other limbs that are there on both sides; x where none is.
Eigen::Vector3f leftOf(const Model& model, std::span<const BoneAnatomy> anatomy);

}  // namespace knuckle
