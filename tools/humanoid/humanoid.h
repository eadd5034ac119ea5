#pragma once

#include "sim/rig/model.h"

namespace knuckle {

/// The project's own rigged figure, generated entirely by this code: an adult of 1.75 m standing at the origin on y =
/// 0, facing +z, left arm towards +x, arms 50 degrees below the horizontal; 19 bones, a closed mesh, smooth skin
/// weights, and two clips: "dance", whose last pose is its first, and "walk", which continues from where it ends.
Model makeHumanoid();

/// Bones of the humanoid, the order of Model::bones.
enum HumanoidBone : uint32_t {
    HIPS,
    SPINE,
    CHEST,
    NECK,
    HEAD,
    CLAVICLE_L,
    UPPER_ARM_L,
    FOREARM_L,
    HAND_L,
    CLAVICLE_R,
    UPPER_ARM_R,
    FOREARM_R,
    HAND_R,
    THIGH_L,
    SHIN_L,
    FOOT_L,
    THIGH_R,
    SHIN_R,
    FOOT_R,
    HUMANOID_BONE_COUNT,
};

/// The "dance" clip for a skeleton like makeHumanoid()'s, with every bone's axes parallel to the model's.
Clip humanoidDance(const std::vector<Bone>& bones);
/// Likewise "walk": two steps along +z, at a metre a second.
Clip humanoidWalk(const std::vector<Bone>& bones);

}  // namespace knuckle
