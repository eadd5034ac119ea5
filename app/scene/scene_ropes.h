#pragma once

#include <string>
#include <vector>

#include "app/scene/scene_parts.h"
#include "sim/rig/model.h"

namespace knuckle {

/// One entry of `objects` that is a rope or cloth.
struct RopeEntry : SceneEntry {
    std::vector<std::string> names;  ///< Of its copies.
    std::vector<Pose> poses;         ///< Of its copies.
    uint32_t material = 0;
    Vector3f velocity{0, 0, 0};
};

/// Whether an entry of `objects` is one of these. They are added after all others, to which they may be attached.
bool isRopeObject(const Json& json);
/// @throws InputError.
void addRopeObject(const RopeEntry& entry);

/// The actor's model, as it is read for cloth: triangles without a skeleton.
std::shared_ptr<const Model> readClothModel(SceneContext& context, const Json& object, const std::string& pointer);

}  // namespace knuckle
