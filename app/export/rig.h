#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "app/scene/scene_file.h"
#include "sim/rig/import/import.h"
#include "sim/solver/measure/state.h"

namespace knuckle {

/// What moves in the rest pose of an object, and by which bodies. Its skeleton is that of the model that an actor was
/// made of, or where only an actor file is known its bodies.
struct Rig {
    uint32_t object = 0;           ///< Index into World::objects; the model has its name.
    Model model;                   ///< Without clips.
    std::vector<uint32_t> bodies;  ///< Per bone of the model: index into World::bodies.
};

/// Of all actors of a scene, in the order of objects. Reads their models.
/// @param surface whether their meshes and textures are wanted. @throws InputError as importModel().
std::vector<Rig> rigsOf(const Scene& scene, bool surface);

/// How a body has moved what was in its object's rest pose.
Eigen::Isometry3f motionOf(const Body& body, const BodyState& state);

}  // namespace knuckle
