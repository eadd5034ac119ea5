#include "app/serve/changes/live_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/json/json.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr const char *GRAVITY = "gravity", *WIND = "wind", *DAMPING = "linearDamping", *MAX_SPEED = "maxSpeed",
                     *MOTOR = "motor ";

std::vector<float> listOf(const Vector3f& v)
{
    return {v.x(), v.y(), v.z()};
}

/// Fluids have substeps for the gravity that they begin with: of twice as much they do not yet boil.
float mostGravity(const World& world)
{
    return world.fluidCount > 0 ? 2.0f * std::max(9.81f, world.settings.gravity.norm()) : 100.0f;
}

bool isMotor(const Joint& joint)
{
    return joint.type == JointType::Hinge && joint.drive.isMotor();
}

/// A hinge that turns to an angle, instead of at a speed.
bool holdsAngle(const TurnDrive& drive)
{
    return drive.stiffness > 0.0f;
}

LiveField motorField(const World& world, uint32_t joint)
{
    const TurnDrive& drive = world.joints[joint].drive;
    const bool angle = holdsAngle(drive);
    const float now = angle ? drive.angle : drive.speed;
    const float most = std::max(angle ? 3.14f : 10.0f, 2.0f * std::abs(now));
    return {MOTOR + world.joints[joint].name, {now}, -most, most, angle ? "rad" : "rad/s", joint};
}

std::vector<LiveField> fieldsOf(const World& world)
{
    const Surroundings begin = Surroundings::of(world);
    const float gravity = mostGravity(world);
    std::vector<LiveField> fields{{GRAVITY, listOf(begin.gravity), -gravity, gravity, "m/s²"}};
    if (world.wind) fields.push_back({WIND, listOf(begin.wind), -50.0f, 50.0f, "m/s"});
    fields.push_back({DAMPING, {begin.linearDamping}, 0.0f, 100.0f, "1/s"});
    fields.push_back({MAX_SPEED, {begin.maxSpeed}, 0.1f, std::max(100.0f, begin.maxSpeed), "m/s"});
    for (uint32_t j = 0; j < world.joints.size(); ++j)
        if (isMotor(world.joints[j])) fields.push_back(motorField(world, j));
    return fields;
}

}  // namespace

LiveFields::LiveFields(const World& world)
    : world_(world), surroundings_(Surroundings::of(world)), fields_(fieldsOf(world))
{
}

void LiveFields::reset()
{
    surroundings_ = Surroundings::of(world_);
    fields_ = fieldsOf(world_);
}

const LiveField& LiveFields::check(const std::string& name, const std::vector<float>& value) const
{
    const auto found = std::ranges::find(fields_, name, &LiveField::name);
    if (found == fields_.end()) {
        std::vector<std::string> known;
        for (const LiveField& field : fields_) known.push_back(field.name);
        throw InputError(fmt::format("\"{}\" cannot change while it runs; {}; all else by \"restart\"", name,
                                     suggestion(name, known)));
    }
    if (value.size() != found->value.size())
        throw InputError(fmt::format("{} is {}; give as many", name,
                                     found->value.size() == 1 ? "one number" : "a list of three numbers"));
    for (const float v : value)
        if (!(v >= found->least && v <= found->most))
            throw InputError(
                fmt::format("{} is {:g}; give {:g} to {:g} {}", name, v, found->least, found->most, found->unit));
    return *found;
}

void LiveFields::set(Solver& solver, const std::string& name, const std::vector<float>& value)
{
    const LiveField& field = check(name, value);
    if (field.joint != NO_INDEX) {
        TurnDrive drive = world_.joints[field.joint].drive;
        (holdsAngle(drive) ? drive.angle : drive.speed) = value[0];
        solver.drive(field.joint, drive);
    } else {
        const Vector3f vector = value.size() == 3 ? Vector3f(value[0], value[1], value[2]) : Vector3f::Zero();
        if (name == GRAVITY) surroundings_.gravity = vector;
        if (name == WIND) surroundings_.wind = vector;
        if (name == DAMPING) surroundings_.linearDamping = value[0];
        if (name == MAX_SPEED) surroundings_.maxSpeed = value[0];
        solver.surround(surroundings_);
    }
    fields_[static_cast<size_t>(&field - fields_.data())].value = value;
}

}  // namespace knuckle
