#pragma once

#include <cstdint>
#include <string>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Adds those of the document, and the ones that every scene has. @throws InputError.
void addMaterials(SceneContext& context, const Json& materials);

/// Index of the material `name`. @throws InputError with `pointer` where there is none.
uint32_t findMaterial(const SceneContext& context, const std::string& name, const std::string& pointer);

/// @throws InputError at `pointer` unless the material is a fluid.
void requireFluid(const SceneContext& context, uint32_t material, const std::string& pointer);

/// @throws InputError for a thing that is easier to start than to keep moving.
void checkFriction(const SceneEntry& entry);

}  // namespace knuckle
