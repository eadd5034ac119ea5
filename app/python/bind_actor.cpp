#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

#include "app/files/actor_check.h"
#include "app/files/actor_file.h"
#include "app/files/actor_mass.h"
#include "app/files/npz/actor_arrays.h"
#include "app/json/fields.h"
#include "app/python/bind.h"
#include "sim/base/fnv_hash.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/import/import.h"
#include "sim/rig/skin/actor_skin.h"

namespace py = pybind11;
using namespace py::literals;

namespace knuckle {

namespace {

std::shared_ptr<Actor> voxelized(const std::filesystem::path& path, uint32_t particles, float diameter, float height)
{
    ImportOptions options;
    options.fit.height = height;
    options.fit.centering = Centering::WhereFar;
    options.surface = true;
    ActorOptions wanted;
    wanted.voxels.diameter = diameter;
    wanted.particleCount = particles;
    const Model model = importModel(path.string(), options);
    auto actor = std::make_shared<Actor>(makeActor(model, wanted));
    actor->model = {path.string(), options.fit, {}};
    requireUsable(path.string(), *actor);
    actor->skin = makeActorSkin(*actor, model);
    return actor;
}

py::object bytesFile(const py::object& bytes)
{
    return py::module_::import("io").attr("BytesIO")(bytes);
}

/// As numpy.load() has them from its file.
py::dict arraysOfActor(const Actor& actor)
{
    const py::object archive = py::module_::import("numpy").attr("load")(bytesFile(py::bytes(npzText(actor))));
    py::dict arrays;
    for (const py::handle name : archive) arrays[name] = archive[name];
    return arrays;
}

std::shared_ptr<Actor> actorOfArrays(const py::dict& arrays)
{
    const py::object file = bytesFile(py::bytes());
    py::module_::import("numpy").attr("savez")(file, **arrays);
    const std::string bytes = file.attr("getvalue")().cast<py::bytes>();
    return std::make_shared<Actor>(actorOf({"actor", documentOf(readZip(bytes, "actor"), "actor")}));
}

/// The weights as two arrays, [n, 4].
py::tuple weightsOf(const std::vector<BodyWeights>& weights)
{
    const auto count = static_cast<py::ssize_t>(weights.size());
    py::array_t<uint32_t> bodies({count, py::ssize_t{4}});
    py::array_t<float> shares({count, py::ssize_t{4}});
    for (size_t i = 0; i < weights.size(); ++i) {
        std::ranges::copy(weights[i].bodies, bodies.mutable_data(static_cast<py::ssize_t>(i)));
        std::ranges::copy(weights[i].weights, shares.mutable_data(static_cast<py::ssize_t>(i)));
    }
    return py::make_tuple(bodies, shares);
}

py::list bodiesOf(const Actor& actor)
{
    py::list bodies;
    const std::vector<ActorMass> masses = massesOf(actor);
    for (size_t b = 0; b < masses.size(); ++b) {
        const ActorBody& body = actor.bodies[b];
        const auto& [mass, centre, inertia] = masses[b];
        // The matrix is the same by rows and by columns.
        bodies.append(py::dict("name"_a = body.name, "parent"_a = body.parent, "particles"_a = body.particles,
                               "merged_bones"_a = body.mergedBones, "mass"_a = mass,
                               "centre"_a = arrayOf({centre}).squeeze(),
                               "inertia"_a = py::array_t<float>({3, 3}, inertia.data())));
    }
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

/// The name of a file with the actor, which is there as long as the program runs.
std::string temporaryFile(const Actor& actor)
{
    static const std::string folder = [] {
        std::string made = py::module_::import("tempfile").attr("mkdtemp")("", "knuckle-").cast<std::string>();
        py::module_::import("atexit").attr("register")(py::module_::import("shutil").attr("rmtree"), made, true);
        return made;
    }();
    Actor plain = actor;
    plain.skin = {};  // a scene reads that from the model
    FnvHash hash;
    hash.add(std::string_view(actorText(plain)));
    std::string path = fmt::format("{}/{}.npz", folder, hashText(hash.value()));
    if (!std::filesystem::exists(path)) writeActor(path, plain);
    return path;
}

}  // namespace

py::object fileOfActor()
{
    return py::cpp_function([](const py::object& value) {
        if (!py::isinstance<Actor>(value))
            throw py::type_error("a scene has no values of the type " +
                                 py::str(py::type::of(value)).cast<std::string>());
        return temporaryFile(value.cast<const Actor&>());
    });
}

void bindActor(py::module_& module)
{
    py::class_<Actor, std::shared_ptr<Actor>>(module, "Actor", "A ragdoll of particles in its rest pose.")
        .def(
            py::init(&actorOfArrays), "arrays"_a,
            "An actor of a dict of arrays, those of its .npz file (docs/actor-format.md): particles [n, 3], diameter, "
            "bodies_name, bodies_particles, bodies_particles_starts ...\n\n"
            "Raises InputError for a wrong shape, numbers that are not finite, unknown names, and all that is wrong in "
            "a file.")
        .def("arrays", &arraysOfActor, "The same arrays, as a dict: copies.")
        .def_readonly("name", &Actor::name)
        .def_readonly("diameter", &Actor::diameter, "Of a particle [m].")
        .def_property_readonly(
            "particles", [](const Actor& actor) { return arrayOf(actor.particles); },
            "Rest positions [m], float32 [n, 3].")
        .def_property_readonly(
            "bodies", &bodiesOf,
            "A list of dicts: 'name', 'parent' (an index, -1: none), 'particles' (indices; shared "
            "ones stand in several bodies), 'merged_bones'; at 1000 kg/m3 'mass' [kg], 'centre' [m], "
            "'inertia' about that [3, 3].")
        .def_property_readonly(
            "particle_weights", [](const Actor& actor) { return weightsOf(actor.skin.ofParticles); },
            "What the skin has where each particle is nearest to it: bodies and their weights, [n, 4] both; [0, 4] if "
            "not known.")
        .def_property_readonly(
            "vertex_weights", [](const Actor& actor) { return weightsOf(actor.skin.ofVertices); },
            "The same of the vertices of the model's mesh.")
        .def_property_readonly(
            "vertices", [](const Actor& actor) { return arrayOf(actor.skin.vertices); }, "Of that mesh at rest [m].")
        .def_property_readonly("joints", &jointsOf,
                               "A list of dicts: 'name', 'type' (ball, hinge, universal, stiff), 'parent' and 'child' "
                               "(indices of bodies), 'anchor' [m], 'axis', 'particles' (shared ones).")
        .def_readonly("notes", &Actor::notes, "What was merged, dropped or assumed.")
        .def(
            "save", [](const Actor& actor, const std::filesystem::path& path) { writeActor(path.string(), actor); },
            "path"_a, "Writes it as its name ends: as a scene loads it, .json or .npz; .urdf or .mjcf.")
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
        "path"_a, "Reads an actor file, .json or .npz.");
}

}  // namespace knuckle
