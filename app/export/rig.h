#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "app/scene/scene_file.h"
#include "sim/rig/import/import.h"
#include "sim/solver/measure/state.h"

namespace knuckle {

/// The skeleton and mesh of an object in the rest pose, and the bodies that move them. The skeleton is that of the
/// actor's model, or if only an actor file is known, its bodies.
struct Rig {
    uint32_t object = 0;           ///< Index into World::objects; the model has its name.
    Model model;                   ///< Without clips.
    std::vector<uint32_t> bodies;  ///< Per bone of the model: index into World::bodies.
};

/// Rigs of all actors of a scene, in the order of objects. Reads their models.
/// @param surface whether their meshes and textures are needed. @throws InputError as importModel().
std::vector<Rig> rigsOf(const Scene& scene, bool surface);

/// Adds a vertex that one bone alone moves. @param normal unit. @param color linear.
void addRigidVertex(Rig& rig, uint32_t bone, const Vector3f& place, const Vector3f& normal, const Vector3f& color);

/// The motion of a body from its object's rest pose.
Eigen::Isometry3f motionOf(const Body& body, const BodyState& state);

}  // namespace knuckle
