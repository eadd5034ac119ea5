#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/json/json.h"
#include "app/python/bind.h"
#include "app/python/session.h"
#include "app/scene/joints/scene_joints.h"
#include "sim/base/errors.h"

namespace py = pybind11;
using namespace py::literals;

namespace knuckle {

namespace {

std::string bodyName(const World& world, const Body& body)
{
    return body.object == NO_INDEX ? body.name : nameInScene(world, body);
}

py::dict bodiesOf(Session& session)
{
    const World& world = session.scene().world;
    const std::vector<BodyState> states = session.bodies();
    const auto count = static_cast<py::ssize_t>(states.size());
    std::vector<std::string> names;
    for (const Body& body : world.bodies) names.push_back(bodyName(world, body));
    py::array_t<float> positions({count, py::ssize_t{3}}), rotations({count, py::ssize_t{4}}),
        velocities({count, py::ssize_t{3}}), spins({count, py::ssize_t{3}}), masses(count);
    auto p = positions.mutable_unchecked<2>(), r = rotations.mutable_unchecked<2>(),
         v = velocities.mutable_unchecked<2>(), w = spins.mutable_unchecked<2>();
    auto m = masses.mutable_unchecked<1>();
    for (py::ssize_t i = 0; i < count; ++i) {
        const BodyState& state = states[static_cast<size_t>(i)];
        for (int axis = 0; axis < 3; ++axis) {
            p(i, axis) = state.position[axis];
            v(i, axis) = state.velocity[axis];
            w(i, axis) = state.angularVelocity[axis];
        }
        for (int part = 0; part < 4; ++part) r(i, part) = state.rotation.coeffs()[part];
        m(i) = world.bodies[static_cast<size_t>(i)].mass;
    }
    return py::dict("name"_a = names, "position"_a = positions, "rotation"_a = rotations, "velocity"_a = velocities,
                    "angular_velocity"_a = spins, "mass"_a = masses);
}

py::list jointsOf(const Session& session)
{
    const World& world = session.scene().world;
    py::list joints;
    for (const Joint& joint : world.joints)
        joints.append(py::dict("parent"_a = bodyName(world, world.bodies[joint.parent]),
                               "child"_a = bodyName(world, world.bodies[joint.child]),
                               "particles"_a = joint.particles));
    return joints;
}

py::array_t<bool> activeOf(Session& session)
{
    const ParticleState state = session.particles();
    py::array_t<bool> active(static_cast<py::ssize_t>(state.positions.size()));
    auto values = active.mutable_unchecked<1>();
    for (size_t i = 0; i < state.positions.size(); ++i)
        values(static_cast<py::ssize_t>(i)) = state.inactive.empty() || !state.inactive[i];
    return active;
}

py::dict measuresOf(Session& session)
{
    const Measures m = session.measure();
    return py::dict("contacts"_a = m.contactCount, "mean_penetration"_a = m.meanPenetration,
                    "worst_penetration"_a = m.worstPenetration, "mean_joint_gap"_a = m.meanJointGap,
                    "worst_joint_gap"_a = m.worstJointGap, "mean_density_error"_a = m.meanDensityError,
                    "worst_density_error"_a = m.worstDensityError, "worst_stretch"_a = m.worstStretch,
                    "max_speed"_a = m.maxSpeed, "kinetic_energy"_a = m.kineticEnergy);
}

SessionHolder simulationOf(std::shared_ptr<Scene> scene, const std::string& device, std::optional<int64_t> seed)
{
    endLeftSessions();
    if (seed) {
        Json document = Json::parse(scene->document);
        document["seed"] = *seed;
        scene = std::make_shared<Scene>(loadStoredScene(scene->file, document.dump()));
    }
    return SessionHolder(new Session(std::move(scene), device));
}

/// Looks for Ctrl-C now and then, which waits for the end of what runs in C++.
void stepOf(Session& session, int64_t count)
{
    constexpr int64_t MOST = 8;
    if (count < 0) throw InputError(fmt::format("count must be 0 or more; it is {}", count));
    endLeftSessions();
    do {
        const int64_t now = std::min(count, MOST);
        {
            const py::gil_scoped_release released;
            session.step(static_cast<uint32_t>(now));
        }
        count -= now;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    } while (count > 0);
}

PictureWish wishOf(std::array<int64_t, 2> size, const py::object& camera, const std::string& quality = {})
{
    for (const int64_t pixels : size)
        if (pixels < 0 || pixels > std::numeric_limits<uint32_t>::max())
            throw InputError(fmt::format("size must be a width and a height [pixels]; it is {}, {}", size[0], size[1]));
    PictureWish wish{static_cast<uint32_t>(size[0]), static_cast<uint32_t>(size[1]), quality, {}};
    if (!camera.is_none()) wish.camera = jsonOf(camera, "camera").dump();
    return wish;
}

py::array_t<uint8_t> renderOf(Session& session, std::array<int64_t, 2> size, const py::object& camera,
                              const std::string& quality)
{
    const Image image = session.picture(wishOf(size, camera, quality));
    py::array_t<uint8_t> pixels({py::ssize_t{image.height}, py::ssize_t{image.width}, py::ssize_t{4}});
    uint8_t* out = pixels.mutable_data();
    for (size_t i = 0; i < size_t{image.width} * image.height; ++i) {
        for (int c = 0; c < 3; ++c) *out++ = image.rgb[3 * i + static_cast<size_t>(c)];
        *out++ = image.alpha.empty() ? uint8_t{255} : image.alpha[i];
    }
    return pixels;
}

py::dict cameraOf(const Layers& layers)
{
    py::array_t<double> matrix({4, 4});
    auto out = matrix.mutable_unchecked<2>();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) out(row, column) = layers.camera.toWorld.matrix()(row, column);
    return py::dict("fx"_a = layers.camera.focal, "fy"_a = layers.camera.focal, "cx"_a = 0.5 * layers.width,
                    "cy"_a = 0.5 * layers.height, "camera_to_world"_a = matrix);
}

py::dict layersOf(Session& session, std::array<int64_t, 2> size, const py::object& camera)
{
    const Layers layers = session.layers(wishOf(size, camera));
    const auto height = static_cast<py::ssize_t>(layers.height), width = static_cast<py::ssize_t>(layers.width);
    py::array_t<float> depth({height, width}), normals({height, width, py::ssize_t{3}}),
        albedo({height, width, py::ssize_t{3}});
    py::array_t<uint32_t> object({height, width}), body({height, width}), material({height, width}),
        particle({height, width}), collider({height, width});
    for (size_t i = 0; i < layers.places.size(); ++i) {
        const gpu::vec4 &place = layers.places[i], &color = layers.albedo[i];
        depth.mutable_data()[i] = place.w < 0.0f ? std::numeric_limits<float>::infinity() : place.w;
        std::ranges::copy(std::array{place.x, place.y, place.z}, normals.mutable_data() + 3 * i);
        std::ranges::copy(std::array{color.x, color.y, color.z}, albedo.mutable_data() + 3 * i);
        const PixelIds ids = session.things().idsOf(layers.things[i]);
        object.mutable_data()[i] = ids.object;
        body.mutable_data()[i] = ids.body;
        material.mutable_data()[i] = ids.material;
        particle.mutable_data()[i] = ids.particle;
        collider.mutable_data()[i] = ids.collider;
    }
    return py::dict("depth"_a = depth, "normals"_a = normals, "albedo"_a = albedo, "object"_a = object, "body"_a = body,
                    "material"_a = material, "particle"_a = particle, "collider"_a = collider,
                    "objects"_a = session.things().names(), "camera"_a = cameraOf(layers));
}

}  // namespace

void bindSimulation(py::module_& module)
{
    py::class_<SessionState, std::shared_ptr<SessionState>>(module, "State", "A state of a simulation, to return to.")
        .def_readonly("steps", &SessionState::steps);
    SessionClass simulation(
        module, "Simulation",
        "A scene on the device. The same scene, program and driver give the same bits. SI units, +Y "
        "up; particles and bodies are in the order of the scene. All calls must come from the thread "
        "that made it.");
    simulation
        .def(py::init(&simulationOf), py::arg("scene").none(false), "device"_a = "auto", "seed"_a = py::none(),
             "`device`: 'auto' (a GPU, else the CPU), 'gpu', 'software' or a number of `knuckle info`; the first "
             "simulation of a thread chooses for all. `seed`: the scene's own `seed` instead; another number, and all "
             "that is "
             "random in it comes out otherwise. Compiles kernels, which takes seconds at first.")
        .def("step", &stepOf, "count"_a = 1,
             "Advances by `count` times scene.time_step. Raises RunError for a state that is no longer finite.")
        .def_property_readonly("time", &Session::time, "Since the start [s].")
        .def_property_readonly("steps", &Session::steps, "Since the start.")
        .def_property_readonly("device", &Session::deviceName, "As the driver names it.")
        .def(
            "positions", [](Session& s) { return arrayOf(s.particles().positions); },
            "Of all particles [m], float32 [n, 3].")
        .def(
            "velocities", [](Session& s) { return arrayOf(s.particles().velocities); },
            "Of all particles [m/s], float32 [n, 3].")
        .def("active", &activeOf, "Which particles are there, bool [n]: not what emitters keep, nor what has drained.")
        .def("bodies", &bodiesOf,
             "A dict: 'name', a list, 'object/body' of objects with several; arrays float32 'position' (mass centres) "
             "[n, 3] [m], 'rotation' [n, 4] (quaternions x, y, z, w, from the pose at rest), 'velocity' [n, 3] [m/s], "
             "'angular_velocity' [n, 3] [rad/s], 'mass' [n] [kg].")
        .def("joints", &jointsOf,
             "A list of dicts: 'parent' and 'child', names of bodies; 'particles' that they share.")
        .def("measure", &measuresOf,
             "How well the state holds together: a dict of depths and gaps [m], speeds, energy.")
        .def(
            "hash", [](Session& s) { return fmt::format("{:016x}", s.hash()); },
            "Of the bits of all positions and velocities, as `knuckle render --hash` prints it.")
        .def(
            "save_state", [](Session& s) { return std::make_shared<SessionState>(s.save()); },
            "A State, for load_state().")
        .def("load_state", &Session::load, "state"_a,
             "Returns to a State of a simulation of the same scene; steps from there give the same bits.")
        .def("render", &renderOf, "size"_a = std::array<int64_t, 2>{640, 360}, "camera"_a = py::none(),
             "quality"_a = "",
             "A picture, uint8 [height, width, 4]. `camera`: a dict with the fields of a scene's camera, else the "
             "scene's shots; `quality`: 'draft', 'good' or 'final', else the scene's.")
        .def("layers", &layersOf, "size"_a = std::array<int64_t, 2>{640, 360}, "camera"_a = py::none(),
             "What each pixel of a picture shows, a dict of arrays [height, width]: float32 'depth' along the camera's "
             "axis [m] (infinity: nothing), 'normals' in the world and 'albedo' [height, width, 3]; uint32 'object', "
             "'body', 'material', 'particle', 'collider', each an index and 1 (0: none); 'objects', names; 'camera', a "
             "dict of 'fx', 'fy', 'cx', 'cy' [pixels] and 'camera_to_world' [4, 4]. As --export layers writes them.");
    bindChanges(simulation);
}

}  // namespace knuckle
