#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/json.h"
#include "sim/actor/actor.h"
#include "sim/world/builder.h"

/// The parts of a scene file, from documents that the schema has completed.
namespace knuckle {

/// Rotation about the fixed axes x, y, z in this order, from `rotation` [degrees]; identity where there is none.
Quaternionf readRotation(const Json& json);

/// What objects need to know about the scene that they stand in.
struct SceneContext {
    std::string path;                            ///< Of the scene file; other paths are relative to its folder.
    WorldBuilder& builder;
    std::map<std::string, uint32_t> materials;   ///< Indices by name.
    std::map<std::string, Actor> actors = {};    ///< Read or made already, by what was asked for.
};

/// `file` beside the scene. @throws InputError with `pointer` when there is none.
std::string existingFile(const SceneContext& context, const std::string& file, const std::string& pointer);

/// Adds one entry of `colliders`, which may stand for several. @throws InputError.
void addColliders(SceneContext& context, const Json& json, size_t index);
/// Adds the grid of a collider of the type `mesh` or `heightfield`, and says so in `collider`. @throws InputError.
void addMeshGrid(SceneContext& context, const Json& json, const std::string& pointer, Collider& collider);
void addHeightfield(SceneContext& context, const Json& json, const std::string& pointer, Collider& collider);

/// Adds one entry of `objects` with its copies. @throws InputError.
void addObjects(SceneContext& context, const Json& json, size_t index);

/// Places of an object's copies. Deterministic: the same seed gives the same places everywhere.
std::vector<Pose> repeatedPoses(const Json& object);
/// Product of repeat.counts, exact up to 1e18.
uint64_t copyCount(const Json& object);

/// The actor for an object of type `actor` or a rigid mesh, made at most once for the same file and options.
const Actor& findActor(SceneContext& context, const Json& object, const std::string& pointer);

}  // namespace knuckle
