#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/base/no_index.h"
#include "sim/rig/mesh/voxelize.h"
#include "sim/world/joint/joint.h"

namespace knuckle {

/// Bones are named as they are, or by patterns in which `*` stands for any letters and `?` for one (name_pattern.h).
struct ArticulationOptions {
    std::map<std::string, JointType> types;     ///< By the name of the child bone; wins over anatomy.
    std::map<std::string, Vector3f> axes;       ///< Hinge or universal axis, not zero, by the name of the child bone.
    std::map<std::string, JointLimits> limits;  ///< By the name of the child bone.
    std::map<std::string, JointStrength> strengths;  ///< The same.
    std::vector<std::string> keep;   ///< Bones that get bodies of their own if they have enough particles.
    std::vector<std::string> merge;  ///< Bones that join the body that they hang on; wins over `keep`.
    /// Joints without options get the limits of a human body's. Spine, neck and collar bones then give a little;
    /// without limits they are stiff.
    bool limited = true;
    /// Leaves out one layer of a ball or hinge joint's child where it would touch the parent, so that the joint can
    /// turn before the two sides meet. Joints with limits need no such room: their bodies never touch.
    bool clearJoints = true;
};

/// Which bones have bodies, as decided for an actor of the same model (planOf()).
struct BodyPlan {
    std::vector<uint32_t> owners;  ///< Per bone of the model, the bone of the body that moves it; empty: no plan.
    std::vector<uint32_t> above;   ///< Per bone with a body, the bone of its parent; NO_INDEX: none.

    bool empty() const { return owners.empty(); }
    bool hasBody(uint32_t bone) const { return owners[bone] == bone; }
};

struct ActorOptions {
    std::string name;  ///< Empty: the model's.
    VoxelOptions voxels;
    uint32_t particleCount = 0;  ///< Of the actor that makeActor() makes; 0: the diameter decides.
    ArticulationOptions articulation;
    BodyPlan plan = {};      ///< Bodies at any diameter, instead of those that it has room for.
    bool alongBones = true;  ///< Long limbs get lattices of their own (fillAlongBones()), instead of one for all.
};

}  // namespace knuckle
