#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/actor/actor.h"
#include "sim/actor/mesh/voxelize.h"
#include "sim/actor/model.h"

namespace knuckle {

/// Bones are named as they are, or by patterns in which `*` stands for any letters and `?` for one (name_pattern.h).
struct ArticulationOptions {
    std::map<std::string, JointType> types;     ///< By the name of the child bone; wins over anatomy.
    std::map<std::string, Vector3f> axes;       ///< Hinge or universal axis, not zero, by the name of the child bone.
    std::map<std::string, JointLimits> limits;  ///< By the name of the child bone.
    std::map<std::string, JointStrength> strengths;  ///< The same.
    std::vector<std::string> keep;   ///< Bones that get bodies of their own, where they have particles enough.
    std::vector<std::string> merge;  ///< Bones that are part of the body that they hang on; wins over `keep`.
    /// Joints that nobody says anything about have the limits of a human body's. Spine, neck and collar bones then give
    /// a little; without, they are stiff.
    bool limited = true;
    /// Leave one layer of a ball or hinge joint's child out where it would touch the parent, so that the joint can
    /// turn before the two sides meet. Joints with limits need no such room: their bodies never touch.
    bool clearJoints = true;
};

struct ActorOptions {
    std::string name;  ///< Empty: the model's.
    VoxelOptions voxels;
    uint32_t particleCount = 0;  ///< Of the actor that makeActor() makes; 0: by the diameter.
    ArticulationOptions articulation;
    bool alongBones = true;  ///< Long limbs stand on lattices of their own (fillAlongBones()), not all on one.
};

/// Fills the model with particles and cuts it into bodies that share particles at the joints.
///
/// Each particle belongs to the limb that weighs most at the nearest point of the skin, with what twists with it or is
/// attached to it (readAnatomy()). A limb with fewer than four particles, or with coplanar ones, joins the body that it
/// hangs on. Every body but the first has one joint, with a body before it; the joints form a tree. Particles of a
/// joint: ball one, hinge two or more on its axis, stiff four, universal a flat body of five (named after the bone with
/// "/cross" added) that shares two with each side, and then stands as two joints of type Universal in a row. A model
/// without bones becomes one body without joints.
/// @param solid of the model's mesh.
/// @throws InputError as voxelize() does, and for an override that names no bone of the model.
Actor articulate(const Model& model, const Solid& solid, const ActorOptions& options);

}  // namespace knuckle
