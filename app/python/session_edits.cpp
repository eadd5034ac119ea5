// Changes of a running simulation.
#include <fmt/format.h>

#include "app/python/session.h"
#include "app/scene/names/named.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

void requireFinite(const char* what, const Vector3f& v)
{
    if (!v.allFinite()) throw InputError(fmt::format("{} must be finite; it is {}, {}, {}", what, v.x(), v.y(), v.z()));
}

/// @throws InputError for a body that nothing moves now.
void requireFree(const StateEdit& edit, const World& world, const std::string& name,
                 const std::vector<uint32_t>& bodies)
{
    for (const uint32_t body : bodies) {
        if (edit.responds(body)) continue;
        const bool follows = world.bodies[body].motion == Motion::Animated;
        throw InputError(fmt::format("\"{}\" {}, and nothing else moves it; release() it first", name,
                                     follows ? "follows its clip" : "is held"));
    }
}

}  // namespace

void Session::setVelocity(const std::string& name, const Vector3f& velocity, const Vector3f& spin)
{
    requireFinite("velocity", velocity);
    requireFinite("angular_velocity", spin);
    const World& world = scene_->world;
    const Named what = named(world, name);
    if (what.isLoose() && !spin.isZero())
        throw InputError(fmt::format("\"{}\" consists of loose particles; angular_velocity is of bodies", name));
    solver_.here().edit([&](StateEdit& edit) {
        for (uint32_t p = what.first; what.isLoose() && p < what.end; ++p) edit.setParticleVelocity(p, velocity);
        if (what.isLoose()) return;
        requireFree(edit, world, name, what.bodies);
        edit.setVelocity(what.bodies, {velocity, spin, edit.pose(what.bodies[0]).translation()});
    });
}

void Session::setPose(const std::string& name, const Vector3f& position, const std::optional<Quaternionf>& rotation)
{
    requireFinite("position", position);
    if (rotation && !(rotation->coeffs().allFinite() && rotation->norm() > 1e-6f))
        throw InputError("rotation must be a quaternion x, y, z, w that is not 0");
    const std::vector<uint32_t> bodies = bodiesNamed(scene_->world, name);
    solver_.here().edit([&](StateEdit& edit) {
        requireFree(edit, scene_->world, name, bodies);
        const Eigen::Isometry3f before = edit.pose(bodies[0]);
        Eigen::Isometry3f now = before;
        if (rotation) now.linear() = rotation->normalized().toRotationMatrix();
        now.translation() = position;
        edit.move(bodies, now * before.inverse());
    });
}

void Session::applyImpulse(const std::string& name, const Vector3f& impulse, const std::optional<Vector3f>& at)
{
    requireFinite("impulse", impulse);
    if (at) requireFinite("at", *at);
    const std::vector<uint32_t> bodies = bodiesNamed(scene_->world, name);
    if (bodies.size() > 1)
        throw InputError(fmt::format("\"{}\" has {} bodies; name one of them, such as \"{}/{}\"", name, bodies.size(),
                                     name, scene_->world.bodies[bodies[0]].name));
    solver_.here().edit([&](StateEdit& edit) {
        requireFree(edit, scene_->world, name, bodies);
        edit.push(bodies[0], impulse, at ? *at : Vector3f(edit.pose(bodies[0]).translation()));
    });
}

void Session::release(const std::string& name)
{
    const std::vector<uint32_t> bodies = withHanging(scene_->world, bodiesNamed(scene_->world, name));
    solver_.here().edit([&](StateEdit& edit) {
        if (!edit.letGo(bodies))
            throw InputError(fmt::format("\"{}\" is held for ever; give it a `release` in the scene, with a `time` "
                                         "beyond its end if only this may let go",
                                         name));
    });
}

void Session::drive(const std::string& name, const TurnDrive& drive)
{
    const World& world = scene_->world;
    const uint32_t joint = drivenJointNamed(world, name);
    if (drive.needsHinge() && world.joints[joint].type != JointType::Hinge)
        throw InputError(fmt::format("\"{}\" is no hinge, which a motor turns", name));
    solver_.here().drive(joint, drive);
}

}  // namespace knuckle
