#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include "app/files/actor_check.h"
#include "app/files/actor_file.h"
#include "app/json/fields.h"
#include "app/python/bind.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/import/import.h"

namespace py = pybind11;
using namespace py::literals;

namespace knuckle {

namespace {

std::shared_ptr<Actor> voxelized(const std::filesystem::path& model, uint32_t particles, float diameter, float height)
{
    ImportOptions options;
    options.fit.height = height;
    options.fit.centering = Centering::WhereFar;
    options.surface = true;
    ActorOptions wanted;
    wanted.voxels.diameter = diameter;
    wanted.particleCount = particles;
    auto actor = std::make_shared<Actor>(makeActor(importModel(model.string(), options), wanted));
    actor->model = {model.string(), options.fit, {}};
    requireUsable(model.string(), *actor);
    return actor;
}

py::list bodiesOf(const Actor& actor)
{
    py::list bodies;
    for (const ActorBody& body : actor.bodies)
        bodies.append(py::dict("name"_a = body.name, "parent"_a = body.parent, "particles"_a = body.particles,
                               "merged_bones"_a = body.mergedBones));
    return bodies;
}

py::list jointsOf(const Actor& actor)
{
    py::list joints;
    for (const ActorJoint& joint : actor.joints)
        joints.append(py::dict("name"_a = joint.name, "type"_a = wordOf(joint.type), "parent"_a = joint.parent,
                               "child"_a = joint.child, "anchor"_a = arrayOf({joint.anchor}).squeeze(),
                               "axis"_a = arrayOf({joint.axis}).squeeze(), "particles"_a = joint.sharedParticles));
    return joints;
}

}  // namespace

void bindActor(py::module_& module)
{
    py::class_<Actor, std::shared_ptr<Actor>>(module, "Actor", "A ragdoll of particles in its rest pose.")
        .def_readonly("name", &Actor::name)
        .def_readonly("diameter", &Actor::diameter, "Of a particle [m].")
        .def_property_readonly(
            "particles", [](const Actor& actor) { return arrayOf(actor.particles); },
            "Rest positions [m], float32 [n, 3].")
        .def_property_readonly("bodies", &bodiesOf,
                               "A list of dicts: 'name', 'parent' (an index, -1: none), 'particles' (indices; shared "
                               "ones stand in several bodies), 'merged_bones'.")
        .def_property_readonly("joints", &jointsOf,
                               "A list of dicts: 'name', 'type' (ball, hinge, universal, stiff), 'parent' and 'child' "
                               "(indices of bodies), 'anchor' [m], 'axis', 'particles' (shared ones).")
        .def_readonly("notes", &Actor::notes, "What was merged, dropped or assumed.")
        .def(
            "save", [](const Actor& actor, const std::filesystem::path& path) { writeActor(path.string(), actor); },
            "path"_a, "Writes it as a scene loads it (JSON).")
        .def("__repr__", [](const Actor& actor) {
            return fmt::format("<knuckle.Actor '{}': {} particles of {:.3g} m, {} bodies, {} joints>", actor.name,
                               actor.particles.size(), actor.diameter, actor.bodies.size(), actor.joints.size());
        });
    module.def("voxelize", &voxelized, "model"_a, "particles"_a = 0, "diameter"_a = 0.0f, "height"_a = 0.0f,
               "Fills a rigged model (glTF, FBX, Collada, BVH ...) with particles. `particles`: as many as this, or "
               "nearly; or `diameter` [m]; else limbs are two to three particles thick. `height` of the figure [m]; 0: "
               "as the file says.");
    module.def(
        "load_actor", [](const std::filesystem::path& path) { return std::make_shared<Actor>(readActor(path)); },
        "path"_a, "Reads an actor file.");
}

}  // namespace knuckle
