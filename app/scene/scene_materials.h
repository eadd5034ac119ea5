#pragma once

#include <cstdint>
#include <string>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Adds the document's materials, and those of every scene. @throws InputError.
void addMaterials(SceneContext& context, const Json& materials);

/// Index of the material `name`. @throws InputError with `pointer` if there is none.
uint32_t findMaterial(const SceneContext& context, const std::string& name, const std::string& pointer);

/// @throws InputError at `pointer` unless the material is a fluid.
void requireFluid(const SceneContext& context, uint32_t material, const std::string& pointer);

/// @throws InputError if kinetic friction exceeds static friction.
void checkFriction(const SceneEntry& entry);

}  // namespace knuckle
