// What a program may change of a running simulation, and what pushes whom.
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string_view>

#include "app/python/bind.h"
#include "app/python/session.h"
#include "sim/base/errors.h"

namespace py = pybind11;
using namespace py::literals;

namespace knuckle {

namespace {

/// So many numbers, of any sequence or array. @throws InputError that names the argument.
template <int COUNT>
Eigen::Matrix<float, COUNT, 1> numbersOf(const py::handle& value, const char* name)
{
    using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
    requireUnmasked(value, name);
    const py::array given = py::array::ensure(value);
    // NumPy would also make numbers of texts and dates, and leave out what is imaginary.
    const bool fits = given && given.ndim() == 1 && given.size() == COUNT &&
                      std::string_view("biufO").find(given.dtype().kind()) != std::string_view::npos;
    const Numbers numbers = fits ? Numbers::ensure(given) : Numbers();
    PyErr_Clear();
    if (!fits || numbers.size() != COUNT)
        throw InputError(fmt::format("{} must be {} numbers, not {}", name, COUNT, said(value)));
    return Eigen::Map<const Eigen::Matrix<double, COUNT, 1>>(numbers.data()).template cast<float>();
}

Vector3f vectorOf(const py::handle& value, const char* name)
{
    return Vector3f(numbersOf<3>(value, name));
}

std::optional<Vector3f> placeOf(const py::handle& value)
{
    if (value.is_none()) return {};
    return Vector3f(numbersOf<3>(value, "at"));
}

void setPose(Session& session, const std::string& name, const py::object& position, const py::object& rotation)
{
    std::optional<Quaternionf> turned;
    if (!rotation.is_none()) turned = Quaternionf(numbersOf<4>(rotation, "rotation"));
    session.setPose(name, vectorOf(position, "position"), turned);
}

void applyForce(Session& session, const std::string& name, const py::object& force, const py::object& at)
{
    session.applyImpulse(name, session.scene().world.settings.timeStep * vectorOf(force, "force"), placeOf(at));
}

void drive(Session& session, const std::string& name, std::optional<float> speed, std::optional<float> angle,
           float torque)
{
    if (!(torque > 0.0f)) throw InputError(fmt::format("torque must be above 0; it is {}", torque));
    if (!speed && !angle) throw InputError("give drive() a speed [rad/s], an angle [rad], or both");
    if (angle && speed && !(*speed > 0.0f)) throw InputError("speed must be above 0 beside an angle");
    for (const std::optional<float>& number : {speed, angle})
        if (number && !std::isfinite(*number)) throw InputError("speed and angle must be finite");
    if (!angle) session.drive(name, speedMotor(*speed, torque));
    else session.drive(name, speed ? angleMotor(*angle, torque, *speed) : angleMotor(*angle, torque));
}

py::dict contactsOf(Session& session)
{
    const World& world = session.scene().world;
    const std::vector<ContactForce> contacts = session.contactForces();
    const std::vector<Vector3f> places = session.particles().positions;
    const auto count = static_cast<py::ssize_t>(contacts.size());
    py::array_t<int32_t> particles({count, py::ssize_t{2}}), bodies({count, py::ssize_t{2}}), colliders(count);
    py::array_t<float> normals(count);
    auto p = particles.mutable_unchecked<2>(), b = bodies.mutable_unchecked<2>();
    auto c = colliders.mutable_unchecked<1>();
    auto n = normals.mutable_unchecked<1>();
    std::vector<Vector3f> positions, forces;
    const auto bodyOf = [&](uint32_t particle) {
        return particle == NO_INDEX ? -1 : static_cast<int32_t>(world.particles[particle].body);
    };
    for (py::ssize_t i = 0; i < count; ++i) {
        const ContactForce& contact = contacts[static_cast<size_t>(i)];
        p(i, 0) = static_cast<int32_t>(contact.particle), p(i, 1) = static_cast<int32_t>(contact.other);
        b(i, 0) = bodyOf(contact.particle), b(i, 1) = bodyOf(contact.other);
        c(i) = static_cast<int32_t>(contact.collider);
        n(i) = contact.normal;
        const Vector3f& first = places[contact.particle];
        positions.push_back(contact.other == NO_INDEX ? first : Vector3f(0.5f * (first + places[contact.other])));
        forces.push_back(contact.force);
    }
    return py::dict("particles"_a = particles, "bodies"_a = bodies, "collider"_a = colliders,
                    "position"_a = arrayOf(positions), "force"_a = arrayOf(forces), "normal_force"_a = normals);
}

}  // namespace

void bindChanges(SessionClass& simulation)
{
    simulation
        .def(
            "set_velocity",
            [](Session& s, const std::string& name, const py::object& velocity, const py::object& spin) {
                s.setVelocity(name, vectorOf(velocity, "velocity"),
                              spin.is_none() ? Vector3f(0, 0, 0) : vectorOf(spin, "angular_velocity"));
            },
            "name"_a, "velocity"_a, "angular_velocity"_a = py::none(),
            "Of an object or a body, 'object/body' [m/s], [rad/s]. Several bodies of an object move as one about the "
            "mass "
            "centre of the first; loose particles all get the velocity.")
        .def("set_pose", &setPose, "name"_a, "position"_a, "rotation"_a = py::none(),
             "Where the mass centre is [m], and how it is turned from its pose at rest, a quaternion x, y, z, w, as "
             "bodies() has both. Of an object, its first body; the others come along. Velocities stay.")
        .def(
            "apply_impulse",
            [](Session& s, const std::string& name, const py::object& impulse, const py::object& at) {
                s.applyImpulse(name, vectorOf(impulse, "impulse"), placeOf(at));
            },
            "name"_a, "impulse"_a, "at"_a = py::none(), "On one body [N s], at a place [m], else its mass centre.")
        .def("apply_force", &applyForce, "name"_a, "force"_a, "at"_a = py::none(),
             "On one body during the next step [N], as an impulse at its beginning.")
        .def("release", &Session::release, "name"_a,
             "Lets go of what is held or follows a clip, with all that hangs on it.")
        .def("drive", &drive, "joint"_a, "speed"_a = py::none(), "angle"_a = py::none(), py::kw_only(), "torque"_a,
             "Drives a joint of the scene that has a motor or a spring: at a speed [rad/s], or to an angle [rad] (at "
             "that speed), with at most this torque [N m].")
        .def("contacts", &contactsOf,
             "Contacts that push, in the last substep: a dict of arrays. int32 'particles' [n, 2] and 'bodies' [n, 2] "
             "(-1: none), 'collider' [n] (-1: the second particle's); float32 'position' [n, 3] [m], between the "
             "particles or of the one; 'force' [n, 3] on the first [N], 'normal_force' [n].");
}

}  // namespace knuckle
