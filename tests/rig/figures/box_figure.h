#pragma once

#include <string>
#include <vector>

#include "sim/rig/actor.h"
#include "sim/rig/anatomy/anatomy.h"

namespace knuckle::test {

/// A bone and the box of skin that follows it alone.
struct BoxBone {
    std::string name, parent;  ///< The parent's name; empty for a root.
    Vector3f head{0, 0, 0};    ///< [m].
    Vector3f centre{0, 0, 0};  ///< Of its box [m].
    Vector3f half{0, 0, 0};    ///< Sizes from there; zero: no skin [m].
};
using BoxBones = std::vector<BoxBone>;

/// A model of bones in the order given, which need not be parents first.
Model boxFigure(const BoxBones& bones);

/// A person of 1.7 m in a T-pose, facing +z: hips, spine, head, and on both sides thigh, shin, foot, upper_arm,
/// forearm.
BoxBones boxPerson();
/// A dog of 0.9 m, facing +z: Hips, Torso, Neck, Head, Tail, and FrontLeg, FrontLowLeg, FrontFoot, BackLeg ... ".L".
BoxBones boxDog();

/// The bone of a name. @throws std::out_of_range.
BoxBone& boneOf(BoxBones& bones, const std::string& name);
uint32_t indexOf(const Model& model, const std::string& bone);
/// The limb of a bone in readAnatomy(), before bodies are joined; "nothing" for none.
std::string ownerOf(const Model& model, const std::string& bone);
/// The body that a body hangs on: "none" for the first one, "no body" if no body has the name.
std::string parentOf(const Actor& actor, const std::string& body);
const ActorJoint& jointOf(const Actor& actor, const std::string& name);
const ActorBody& bodyOf(const Actor& actor, const std::string& name);

}  // namespace knuckle::test
