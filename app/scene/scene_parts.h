#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "app/json/json.h"
#include "app/scene/scene_file.h"
#include "sim/rig/actor.h"
#include "sim/rig/clips/clip_ranges.h"
#include "sim/rig/import/imports.h"
#include "sim/world/builder/builder.h"

/// The parts of a scene file, from documents that the schema has completed.
namespace knuckle {

/// Rotation about the fixed axes x, y, z in this order. @param degrees of each.
Quaternionf rotationOf(const Vector3f& degrees);
/// The same from `rotation`; identity where there is none.
Quaternionf readRotation(const Json& json);

/// Particles of an object, or of one of its copies: from the first to before the end.
struct ParticleRange {
    uint32_t first = 0, end = 0;
};

/// A release by touch, until all objects are there that it may name.
struct PendingTouch {
    std::string pointer, name;
    Release release;
};

/// What objects need to know about the scene that they stand in.
struct SceneContext {
    std::string path;  ///< Of the scene file; other paths are relative to its folder.
    WorldBuilder& builder;
    std::map<std::string, uint32_t> materials;  ///< Indices by name.
    std::map<std::string, Actor> actors = {};   ///< Read or made already, by what was asked for.
    std::shared_ptr<Imports> imports = std::make_shared<Imports>();
    std::set<std::string> drawnFiles = {};                              ///< Of which models are drawn by their meshes.
    std::map<std::string, std::shared_ptr<const SkinMesh>> skins = {};  ///< The same.
    std::map<std::string, uint32_t> clips = {};                         ///< Indices by actor, file and name.
    double duration = 0.0;                                              ///< Of the film [s].
    std::vector<SceneActor> actorUses = {};
    std::vector<std::string> files = {};     ///< Read so far.
    std::vector<std::string> notes = {};     ///< For the user: what of the scene is not as it says.
    std::vector<std::string> warnings = {};  ///< Of that what a run tells, too: Scene::warnings.
    std::map<std::string, std::vector<ParticleRange>> particles = {};  ///< But fluids', by name of object or copy.
    std::vector<std::string> objectNames = {};                         ///< Without those of copies.
    std::vector<PendingTouch> touches = {};
    std::vector<size_t> colliderEntries = {};  ///< Per collider of the world: the entry of `colliders` that it is of.
};

/// One entry of a list of the scene (objects, colliders, ...) while it is being built.
struct SceneEntry {
    SceneContext& context;
    const Json& json;
    std::string pointer;

    /// @throws InputError at a field of the entry.
    [[noreturn]] void fail(const std::string& field, const std::string& message) const
    {
        failAt(context.path, pointer + field, message);
    }
};

/// One entry of `objects` while its copies are made.
struct ObjectEntry : SceneEntry {
    std::string name;
    uint32_t material = 0;
    Vector3f velocity{0, 0, 0}, spin{0, 0, 0};
    std::vector<Pose> poses = {};

    std::string copyName(size_t copy) const;
};

/// Adds an object of type `actor` with its copies. @throws InputError.
void addActors(const ObjectEntry& entry);

/// Of an actor's bodies in their order.
std::vector<std::string> bodyNames(const Actor& actor);
/// Index of an actor's body. @param where in the entry its name stands. @throws InputError where there is none.
uint32_t bodyNamed(const ObjectEntry& entry, const Actor& actor, const std::string& name, const std::string& where);

/// How an actor's clips are played, and what it has to allow for them.
struct PlayedClips {
    std::vector<ClipPlay> plays;
    ClipNeeds needs;
};
/// Adds the clips of an actor's `animation` or `pose`. @throws InputError for clips that are not there or do not fit.
PlayedClips readClips(const ObjectEntry& entry, const Actor& actor);

/// Has the copies of an actor move as their clips say. @param objects of the world, a copy each.
void animateActors(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects,
                   const std::vector<ClipPlay>& plays);

/// Whether an actor has a `drive`.
bool isDriven(const Json& actor);
/// Drives the copies of an actor as `drive` says. @throws InputError.
void driveActors(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects);

/// Lets the copies of an actor go as `release` says. @throws InputError.
void releaseActors(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects);

/// Notes which particles an object has got. @param first of them.
void noteParticles(const ObjectEntry& entry, uint32_t first);
/// Adds the releases by touch, once all objects are there. @throws InputError for a name that none has.
void addTouches(SceneContext& context);

/// The box, sphere, capsule or plane that a drain or a release has.
Collider readRegion(const Json& json);

/// Whether a collider or a rigid object moves by itself.
bool hasMotion(const Json& entry);
/// Adds the clip of its `motion`. @throws InputError.
ClipPlay readMotion(const SceneEntry& entry, const std::string& name);
/// The same of an object, which nothing else may say how to move.
ClipPlay readObjectMotion(const ObjectEntry& entry);

/// By what an actor or a mesh differs from others. @param diameter of its particles [m].
std::string actorKey(const SceneContext& context, const Json& object, const std::string& file, float diameter);

/// The model in a file as an object wants it: an actor one skeleton of it, anything else all that there is.
ModelSource modelOf(const Json& object, const std::string& file);

/// A model, with how it looks where anything draws that. @param clips whether it is wanted with its clips.
std::shared_ptr<const Model> readModel(SceneContext& context, const ModelSource& source, bool clips = true);

/// Whether an object is to be drawn by its mesh.
bool showsSkin(const Json& object);
/// Has the copies of an actor or of a rigid mesh wear the mesh that it was made from. @param objects of the world, a
/// copy each. @throws InputError where there is none.
void wearSkin(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects);

/// Whether an `animation`, a `pose` or a change names a clip.
bool namesClip(const Json& clip);

/// Whether an actor has an `animation` or a `pose`.
bool isAnimated(const Json& actor);

/// Index of the material `name`. @throws InputError with `pointer` where there is none.
uint32_t findMaterial(const SceneContext& context, const std::string& name, const std::string& pointer);

/// A path of the scene, from where the program runs.
std::string besideScene(const SceneContext& context, const std::string& file);

/// `file` beside the scene, noted as read. @throws InputError with `pointer` when there is none.
std::string existingFile(SceneContext& context, const std::string& file, const std::string& pointer);

/// Adds one entry of `colliders`, which may stand for several. @throws InputError.
void addColliders(SceneContext& context, const Json& json, size_t index);
/// Adds the grid of a collider of the type `mesh` or `heightfield`, and says so in `collider`. @throws InputError.
void addMeshGrid(SceneContext& context, const Json& json, const std::string& pointer, Collider& collider);
void addHeightfield(SceneContext& context, const Json& json, const std::string& pointer, Collider& collider);

/// Adds one entry of `objects` with its copies. @throws InputError.
void addObjects(SceneContext& context, const Json& json, size_t index);

/// Places of an object's copies. Deterministic: the same seed gives the same places everywhere.
std::vector<Pose> repeatedPoses(const Json& object);
/// How much later than the first one a copy is moved and let go [s].
float delayOf(const Json& object, size_t copy);
/// What is played, begun later; until then a clip that does not loop is held at its start.
std::vector<ClipPlay> delayed(const World& world, std::vector<ClipPlay> plays, float delay);
/// Product of repeat.counts, exact up to 1e18.
uint64_t copyCount(const Json& object);

/// Uniform in 0 ... 1, made from the generator's raw numbers: those are the same everywhere, unlike those of the
/// standard library's distributions.
inline float uniformFraction(std::mt19937& random)
{
    return static_cast<float>(static_cast<double>(random()) / 4294967296.0);
}

/// The actor for an object of type `actor`, a rigid or soft mesh or a region, made at most once for the same file and
/// options.
/// @param diameter of its particles [m]; 0: the scene's.
const Actor& findActor(SceneContext& context, const Json& object, const std::string& pointer, float diameter = 0.0f);
/// At the diameter that its actor file has, or that fits its model; findActor() has it then, too.
const Actor& actorAlone(SceneContext& context, const Json& object, const std::string& pointer);

/// What the particles of a region without bodies have in common.
struct LooseKind {
    uint32_t material = 0;
    Vector3f velocity{0, 0, 0};  ///< [m/s]
};

/// Adds an object of type `fluid`, at each of `poses`. @param pointer JSON path of the object. @throws InputError.
void addFluid(SceneContext& context, const Json& object, const std::string& pointer, const LooseKind& kind,
              const std::vector<Pose>& poses);

/// @throws InputError at `pointer` unless the material is a fluid.
void requireFluid(const SceneContext& context, uint32_t material, const std::string& pointer);

/// Adds `drains`, then `emitters`, whose nozzles must not be in anything that is there: after everything else.
/// @param duration of the film [s]. @throws InputError.
void addEmitters(SceneContext& context, const Json& root, double duration);

/// Adds an object of type `grains`, at each of `poses`. @param pointer JSON path of the object. @throws InputError.
void addGrains(SceneContext& context, const Json& object, const std::string& pointer, const LooseKind& kind,
               const std::vector<Pose>& poses);

}  // namespace knuckle
