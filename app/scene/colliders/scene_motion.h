#pragma once

#include <string>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Whether a collider or a rigid object moves by itself.
bool hasMotion(const Json& entry);
/// Adds the clip of its `motion`. @throws InputError.
ClipPlay readMotion(const SceneEntry& entry, const std::string& name);
/// The same of an object, which nothing else may say how to move.
ClipPlay readObjectMotion(const ObjectEntry& entry);

}  // namespace knuckle
