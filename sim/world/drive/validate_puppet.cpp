#include <fmt/format.h>
#include <cmath>
#include <stdexcept>

#include "sim/base/errors.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

void require(bool holds, const std::string& what)
{
    if (!holds) throw std::logic_error("puppet: " + what);
}

void requireSpring(const DriveSpring& s)
{
    require(s.frequency >= 0.0f && s.frequency <= 20.0f && s.dampingRatio >= 0.0f && s.dampingRatio <= 2.0f,
            "a frequency or a damping ratio is out of its range");
    require(s.stiffness >= 0.0f && s.damping >= 0.0f && std::isfinite(s.stiffness) && std::isfinite(s.damping),
            "a stiffness or a damping is negative");
    require(s.greatestTorque > 0.0f && s.greatestForce > 0.0f, "a greatest torque or force is not above 0");
}

void validatePuppet(const World& world, const Puppet& puppet)
{
    require(puppet.animation < world.animations.size(), "there is no such animation");
    const Object& object = objectOf(world, puppet);
    if (object.bodyCount < 2)
        throw InputError(
            fmt::format("\"{}\" is one body, without a joint to drive; take its `drive` away", object.name));
    require(puppet.joints.size() == object.bodyCount && puppet.limpTimes.size() == object.bodyCount,
            "it has not one drive for each body");
    for (const DriveSpring& spring : puppet.joints) requireSpring(spring);
    for (const Pin& pin : puppet.pins) {
        require(pin.body < object.bodyCount, "there is no body to pin");
        requireSpring(pin.spring);
        require(!pin.spring.isGiven(), "a pin has a frequency, not a stiffness");
    }
    float last = 0.0f;
    for (const StrengthKey& key : puppet.strength) {
        require(key.time >= last && key.value >= 0.0f && std::isfinite(key.value), "its keys are not in order");
        last = key.time;
    }
}

}  // namespace

void validatePuppets(const World& world)
{
    for (const Puppet& puppet : world.puppets) validatePuppet(world, puppet);
}

}  // namespace knuckle
