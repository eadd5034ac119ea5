#pragma once

#include <string>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Whether a collider or a rigid object has a motion.
bool hasMotion(const Json& entry);
/// Adds the clip of its `motion`. @throws InputError.
ClipPlay readMotion(const SceneEntry& entry, const std::string& name);
/// The same for an object, which must have no other source of motion.
ClipPlay readObjectMotion(const ObjectEntry& entry);

}  // namespace knuckle
