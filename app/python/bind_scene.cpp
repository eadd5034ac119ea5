#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include "app/files/assets.h"
#include "app/json/json.h"
#include "app/python/bind.h"
#include "app/scene/scene_file.h"
#include "sim/base/errors.h"

namespace py = pybind11;
using namespace py::literals;

namespace knuckle {

namespace {

std::vector<Override> overridesOf(const py::dict& changes)
{
    std::vector<Override> overrides;
    for (const auto& [path, value] : changes) {
        if (!py::isinstance<py::str>(path))
            throw InputError(fmt::format("changes: {} is no path, as \"solver.substeps\" is one", said(path)));
        const auto name = path.cast<std::string>();
        overrides.push_back({name, jsonOf(value, "changes: " + name, fileOfActor)});
    }
    return overrides;
}

std::shared_ptr<Scene> loadFile(const std::filesystem::path& path, const py::dict& changes)
{
    return std::make_shared<Scene>(loadScene(findAsset(path.string()), overridesOf(changes), true));
}

std::shared_ptr<Scene> loadDict(const py::dict& document, const py::dict& changes, const std::filesystem::path& folder)
{
    Json json = jsonOf(document, "scene", fileOfActor);
    for (const Override& change : overridesOf(changes)) applyOverride(json, change);
    return std::make_shared<Scene>(loadStoredScene((folder / "scene").string(), json.dump()));
}

std::vector<std::string> objectNames(const Scene& scene)
{
    std::vector<std::string> names;
    for (const Object& object : scene.world.objects) names.push_back(object.name);
    return names;
}

}  // namespace

void bindScene(py::module_& module)
{
    py::class_<Scene, std::shared_ptr<Scene>>(module, "Scene",
                                              "A scene file, read and checked: what a Simulation starts from.")
        .def_static("load", &loadFile, "path"_a, "changes"_a = py::dict(),
                    "Reads a scene file. `changes`: fields by their path, as in {'solver.substeps': 8}.\n\n"
                    "Raises InputError with the file and the JSON pointer of what is wrong.")
        .def_static(
            "load", &loadDict, "document"_a, "changes"_a = py::dict(), "folder"_a = ".",
            "The same for a dict with the fields of a scene file, arrays of NumPy among them; `folder` is where "
            "files that it names lie. The `file` of an object may be an Actor.")
        .def_readonly("name", &Scene::name)
        .def_readonly("description", &Scene::description)
        .def_readonly("duration", &Scene::duration, "Of its film [s].")
        .def_readonly("fps", &Scene::framesPerSecond, "Frames a second of its film.")
        .def_readonly("steps_per_frame", &Scene::stepsPerFrame)
        .def_property_readonly(
            "time_step", [](const Scene& scene) { return scene.world.settings.timeStep; }, "Of a step [s].")
        .def_property_readonly("objects", &objectNames, "Names of what has bodies, in order.")
        .def_readonly("notes", &Scene::notes, "Deviations from the file, one sentence each.")
        .def("__repr__", [](const Scene& scene) {
            return fmt::format("<knuckle.Scene '{}': {} particles, {} bodies, {} joints>", scene.name,
                               scene.world.particles.size(), scene.world.bodies.size(), scene.world.joints.size());
        });
}

}  // namespace knuckle
