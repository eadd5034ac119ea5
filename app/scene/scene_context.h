#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/json/json.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_files.h"
#include "sim/world/builder/builder.h"

// Shared data of the parts of a scene file. All read documents that the schema has completed.
namespace knuckle {

/// A release by touch that waits until all objects exist that it may name.
struct PendingTouch {
    std::string pointer, name;
    Release release;
};

/// Data about the scene that objects need.
struct SceneContext {
    std::string path;  ///< Of the scene file.
    WorldBuilder& builder;
    SceneFiles& files;
    double duration = 0.0;                                              ///< Of what is simulated [s].
    std::map<std::string, uint32_t> materials = {};                     ///< Indices by name.
    std::map<std::string, std::shared_ptr<const SkinMesh>> skins = {};  ///< By SceneFiles::actorKey().
    std::map<std::string, uint32_t> clips = {};                         ///< Indices by actor, file and name.
    std::vector<SceneActor> actors = {};
    std::vector<std::string> notes = {};     ///< For the user: deviations from the scene file.
    std::vector<std::string> warnings = {};  ///< Those that a run prints, too: Scene::warnings.
    std::map<std::string, std::vector<ParticleRange>> particles = {};  ///< Except fluids', by name of object or copy.
    std::vector<std::string> objectNames = {};                         ///< Without those of copies.
    std::vector<PendingTouch> touches = {};
    uint32_t bodiesOfObjects = 0;                                 ///< Without those that joints of the scene add.
    std::vector<std::pair<uint32_t, uint32_t>> joinedPairs = {};  ///< Bodies that joints of the scene hold.
    std::map<std::string, HingeBodies> hinges = {};               ///< Joints of the scene, by name.
    std::set<std::string> gearedHinges = {};                      ///< Names that gears give.
    std::vector<std::string> colliderEntries = {};  ///< Per collider of the world: JSON path of its entry.
};

/// One entry of a list of the scene (objects, colliders, ...) during construction.
struct SceneEntry {
    SceneContext& context;
    const Json& json;
    std::string pointer;  ///< JSON path of the entry.

    /// @throws InputError at a field of the entry.
    [[noreturn]] void fail(const std::string& field, const std::string& message) const
    {
        failAt(context.path, pointer + field, message);
    }
    /// Its actor, or that of its shape; see SceneFiles::actor(). @param diameter 0: the scene's [m].
    const Actor& actor(float diameter = 0.0f) const
    {
        return context.files.actor(json, pointer, diameter > 0.0f ? diameter : context.builder.diameter());
    }
};

/// The name of an entry of `objects`: its own, or one by its number.
inline std::string objectName(const Json& object, size_t index)
{
    const std::string name = object["name"];
    return name.empty() ? "object_" + std::to_string(index + 1) : name;
}

/// One entry of `objects` while its copies are made.
struct ObjectEntry : SceneEntry {
    std::string name = {};
    uint32_t material = 0;
    Vector3f velocity{0, 0, 0}, spin{0, 0, 0};
    std::vector<Pose> poses = {};  ///< Of its copies.

    std::string copyName(size_t copy) const { return poses.size() == 1 ? name : name + "_" + std::to_string(copy + 1); }
};

}  // namespace knuckle
