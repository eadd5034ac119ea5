#pragma once

#include "app/scene/scene_context.h"

namespace knuckle {

/// Whether an entry of `objects` joins bodies of others.
bool isJoint(const Json& object);
/// A body as scenes name it: "object", or "object/body" where that has several.
std::string nameInScene(const World& world, const Body& body);
/// Joins the bodies that it names, which exist. @param index of the entry. @throws InputError.
void addSceneJoint(const SceneEntry& entry, size_t index);

}  // namespace knuckle
