#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <span>

#include "app/files/actor_check.h"
#include "app/files/actor_file.h"
#include "app/files/actor_levels.h"
#include "app/files/actor_mass.h"
#include "app/files/assets.h"
#include "app/files/npz/actor_arrays.h"
#include "app/json/fields.h"
#include "app/python/bind.h"
#include "sim/base/fnv_hash.h"
#include "sim/rig/bodies/bone_options.h"
#include "sim/rig/import/import.h"
#include "sim/rig/skin/actor_skin.h"

namespace py = pybind11;
using namespace py::literals;

namespace knuckle {

namespace {

uint32_t countOf(const char* name, int64_t particles)
{
    if (particles < int64_t{FEWEST_PARTICLES} || particles > int64_t{MOST_PARTICLES})
        throw InputError(fmt::format("{}: {} is not from {} to {}", name, particles, FEWEST_PARTICLES, MOST_PARTICLES));
    return static_cast<uint32_t>(particles);
}

/// An actor for each number of particles, the smallest first.
std::vector<std::shared_ptr<Actor>> voxelized(const std::string& path, std::span<const uint32_t> particles,
                                              float diameter, float height)
{
    ImportOptions options;
    options.fit.height = height;
    options.fit.centering = Centering::WhereFar;
    options.surface = true;
    ActorOptions wanted;
    wanted.voxels.diameter = diameter;
    const Model model = importModel(path, options);
    const Figure figure = readFigure(model, rolesWanted(model, wanted.articulation));
    std::vector<std::shared_ptr<Actor>> actors;
    for (Actor& actor : actorsOfLevels(path, figure, particles, wanted)) {
        actor.model = {path, options.fit, {}};
        actor.skin = makeActorSkin(actor, model);
        actors.push_back(std::make_shared<Actor>(std::move(actor)));
    }
    return actors;
}

/// One actor, or a list of one for each of the levels.
py::object voxelizeOnce(const std::filesystem::path& model, int64_t particles, float diameter, float height,
                        const std::optional<std::vector<int64_t>>& levels)
{
    const std::string path = findAsset(model.string());
    if (levels && (particles != 0 || diameter != 0.0f))
        throw InputError("levels: stand for particles and diameter; leave those out");
    if (particles != 0 && diameter != 0.0f) throw InputError("particles: excludes diameter; leave one of them out");
    if (!(diameter >= 0.0f && std::isfinite(diameter)))
        throw InputError(fmt::format("diameter: {} is no length above 0 m", diameter));
    if (!levels) {
        const uint32_t count = particles == 0 ? 0 : countOf("particles", particles);
        return py::cast(voxelized(path, std::array{count}, diameter, height).front());
    }
    if (levels->empty()) throw InputError("levels: is empty; give a number of particles for each actor");
    std::set<uint32_t> sorted;
    for (const int64_t level : *levels) sorted.insert(countOf("levels", level));
    const auto actors = voxelized(path, std::vector<uint32_t>(sorted.begin(), sorted.end()), diameter, height);
    py::list list;
    for (const int64_t level : *levels)
        list.append(
            actors[static_cast<size_t>(std::distance(sorted.begin(), sorted.find(static_cast<uint32_t>(level))))]);
    return list;
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
    ZipEntries entries;
    for (const auto& [name, array] : arrays) {
        if (!py::isinstance<py::str>(name)) throw InputError(fmt::format("actor: has the key {}, no text", said(name)));
        requireUnmasked(array, fmt::format("actor: /{}", name.cast<std::string>()));
        const py::object file = bytesFile(py::bytes());
        py::module_::import("numpy").attr("save")(file, array);
        entries.emplace_back(name.cast<std::string>() + ".npy", file.attr("getvalue")().cast<py::bytes>());
    }
    return std::make_shared<Actor>(actorOf({"actor", documentOf(entries, "actor")}));
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

std::string fileOfActor(const py::handle& value)
{
    return py::isinstance<Actor>(value) ? temporaryFile(value.cast<const Actor&>()) : std::string{};
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
    module.def("voxelize", &voxelizeOnce, "model"_a, "particles"_a = 0, "diameter"_a = 0.0f, "height"_a = 0.0f,
               "levels"_a = py::none(),
               "Fills a rigged model (glTF, FBX, Collada, BVH ...) with particles. `particles`: as many as this, or "
               "nearly; or `diameter` [m]; else limbs are two to three particles thick. `height` of the figure [m]; 0: "
               "as the file says. `levels`, as [300, 1000, 4000]: a list of actors of so many particles each, all with "
               "the bodies and joints of the coarsest, by the same numbers.");
    module.def(
        "load_actor", [](const std::filesystem::path& path) { return std::make_shared<Actor>(readActor(path)); },
        "path"_a, "Reads an actor file, .json or .npz.");
}

}  // namespace knuckle
