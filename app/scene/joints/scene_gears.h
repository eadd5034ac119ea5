#pragma once

#include "app/scene/scene_context.h"

namespace knuckle {

/// Whether an entry of `objects` couples hinges.
bool isGear(const Json& object);
/// Notes the names of joints that gears couple, before those are added.
void noteGearedHinges(SceneContext& context, const Json& objects);
/// Couples the hinges that it names, which exist. @param index of the entry. @throws InputError.
void addSceneGear(const SceneEntry& entry, size_t index);

}  // namespace knuckle
