#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "sim/base/errors.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

void require(bool holds, const char* what)
{
    if (!holds) throw std::logic_error(what);
}

void validateWind(const Wind& wind)
{
    require(wind.velocity.allFinite(), "wind: its velocity is not finite");
    require(std::isfinite(wind.density) && wind.density >= 0.0f, "wind: the air's density must be 0 or more");
    require(wind.gusts >= 0.0f && wind.gusts <= 2.0f, "wind: gusts must be 0 to 2");
    require(wind.gustSize > 0.0f, "wind: the size of gusts must be above 0");
}

void validateField(const ForceField& field)
{
    const Region& region = field.region;
    require(region.shape <= ColliderShape::Capsule, "a force field is a plane, a box, a sphere or a capsule");
    require(region.position.allFinite() && std::abs(region.orientation.norm() - 1.0f) < 1e-3f,
            "a force field's place is not finite");
    require(std::isfinite(field.strength), "a force field's strength is not finite");
    require(region.shape != ColliderShape::Plane || field.falloff != FieldFalloff::Linear || field.strength == 0.0f,
            "a force field below a plane has no edge at which it could end");
}

}  // namespace

void validateForces(const World& world)
{
    if (!hasForces(world)) return;
    if (world.settings.solver == SolverKind::Paper)
        throw InputError("wind and fields are for the method \"impulse\"; take the preset \"paper\" away, or them");
    if (world.settings.sleepSpeed > 0.0f || world.settings.freeze > 0.0f)
        throw InputError("wind and fields may move what rests; set /solver/sleep and /solver/freeze to 0");
    if (world.wind) validateWind(*world.wind);
    for (const ForceField& field : world.forceFields) validateField(field);
}

}  // namespace knuckle
