#include "sim/world/settings.h"

#include <algorithm>
#include <cmath>

#include "shared/constants.h"

namespace knuckle {

uint32_t Settings::substepAt(float time) const
{
    if (std::isinf(time)) return NO_SUBSTEP;
    const double substep = double{timeStep} / substeps;
    return static_cast<uint32_t>(std::min(std::ceil(time / substep - 1e-3), double{NO_SUBSTEP} - 1));
}

uint32_t automaticSubsteps(float diameter, float timeStep, SolverKind solver)
{
    const float more = solver == SolverKind::Paper ? 1.5f : 1.0f;
    const float needed = 5.0f * 4.5f * timeStep / diameter;
    return static_cast<uint32_t>(more * std::clamp(std::ceil(needed - 0.01f), 4.0f, 16.0f));
}

namespace {

/// As many that fluid at rest is denser than asked by `error`, which is 0.59 of pressure / density (h / spacing)^2.
float fluidSubsteps(float spacing, float pressure, float timeStep, float error)
{
    return 0.768f * timeStep / spacing * std::sqrt(pressure / error);
}

}  // namespace

uint32_t automaticFluidSubsteps(float spacing, float pressure, float timeStep)
{
    const float needed = fluidSubsteps(spacing, std::max(pressure, 9.81f * 20.0f * spacing), timeStep, 0.01f);
    const auto chosen = static_cast<uint32_t>(std::clamp(std::ceil(needed - 0.02f), 4.0f, 32.0f));
    return std::max(chosen, leastFluidSubsteps(spacing, pressure, timeStep));
}

uint32_t leastFluidSubsteps(float spacing, float pressure, float timeStep)
{
    const float needed = fluidSubsteps(spacing, pressure, timeStep, 0.06f);
    return static_cast<uint32_t>(std::clamp(std::ceil(needed - 0.02f), 1.0f, 64.0f));
}

float cohesionPressure(float surfaceTension, float spacing)
{
    // 3.3 if positions were independent (2 pi n^2 / 3 int f r^3 over pi n^2 / 8 int f r^4, see fluid_numbers.cpp).
    // This value is measured.
    return 10.4f * surfaceTension / spacing;
}

Settings paperSettings()
{
    Settings s;
    s.solver = SolverKind::Paper;
    s.rotation = RotationMethod::Householder;
    s.grid = GridKind::Hash;
    s.reduction = ReductionKind::Steps;
    s.velocityOrder = VelocityOrder::First;
    s.iterations = 4;
    s.stabilization = 1;
    s.contactMargin = 0.2f;
    s.freeze = 0.5f;
    s.massScaling = 2.0f;
    s.virtualParticles = 0.01f;
    return s;
}

}  // namespace knuckle
