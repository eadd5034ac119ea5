#pragma once

#include <string>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Whether an object is drawn otherwise than as particles: its own `draw` says so, or else that of its material.
/// @param has its surface or its shape. @param what it is, for messages: "a rope". @param material if it is not
/// that of the entry.
/// @throws InputError where a `draw` asks for what it does not have.
bool isDrawnAs(const ObjectEntry& entry, DrawnAs has, const std::string& what, uint32_t material = NO_INDEX);

}  // namespace knuckle
