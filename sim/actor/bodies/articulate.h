#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "sim/actor/actor.h"
#include "sim/actor/import/model.h"
#include "sim/actor/mesh/voxelize.h"

namespace knuckle {

struct ArticulationOptions {
    std::map<std::string, JointType> types;     ///< By the name of the child bone; wins over anatomy.
    std::map<std::string, Vector3f> axes;       ///< Hinge or universal axis, not zero, by the name of the child bone.
    std::map<std::string, JointLimits> limits;  ///< By the name of the child bone.
    std::map<std::string, JointStrength> strengths;  ///< The same.
    /// Joints that nobody says anything about have the limits of a human body's. Spine, neck and collar bones then give
    /// a little; without, they are stiff.
    bool limited = true;
    /// Leave one layer of a ball or hinge joint's child out where it would touch the parent, so that the joint can
    /// turn before the two sides meet.
    bool clearJoints = true;
};

struct ActorOptions {
    std::string name;  ///< Empty: the model's.
    VoxelOptions voxels;
    uint32_t particleCount = 0;  ///< Of the actor that makeActor() makes; 0: by the diameter.
    ArticulationOptions articulation;
};

/// Fills the model with particles and cuts it into bodies that share particles at the joints.
///
/// Each particle belongs to the bone that weighs most at the nearest point of the skin. A bone with fewer than four
/// particles, or with coplanar ones, joins its parent's body. Every body but the first has one joint, with a body
/// before it; the joints form a tree. Particles of a joint: ball one, hinge two or more on its axis, stiff four,
/// universal a flat body of five (named after the bone with "/cross" added) that shares two with each side, and then
/// stands as two joints of type Universal in a row. A model without bones becomes one body without joints.
/// @throws InputError as voxelize() does, and for an override that names no bone of the model.
Actor articulate(const Model& model, const ActorOptions& options);

/// What of a body a bone is, in the words of many programs.
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
};

/// Of a bone, from its name and its parent's and first child's (empty where there is none).
BodyPart partFromName(std::string_view name, std::string_view parentName, std::string_view childName);

/// The joint at the head of a bone, from its name and its parent's and first child's (empty where there is none), in
/// the words of Mixamo, Blender, 3ds Max Biped, Unreal and BVH files: knees, elbows, fingers and toes are hinges,
/// spine, neck and collar bones are stiff, everything else is a ball.
JointType jointTypeFromName(std::string_view name, std::string_view parentName, std::string_view childName);

/// A figure's left, level and unit, from what of it is named left and right; x where nothing is.
/// @param places of the named, in the same order [m].
Vector3f leftOf(std::span<const std::string> names, std::span<const Vector3f> places);

/// -1 for a name that says right, +1 for left, 0 for neither.
int sideFromName(std::string_view name);

}  // namespace knuckle
