#include "sim/world/settings.h"

#include <algorithm>
#include <cmath>

namespace knuckle {

uint32_t automaticSubsteps(float diameter, float timeStep)
{
    const float needed = 5.0f * 4.5f * timeStep / diameter;
    return static_cast<uint32_t>(std::clamp(std::ceil(needed - 0.01f), 4.0f, 16.0f));
}

uint32_t automaticFluidSubsteps(float spacing, float timeStep)
{
    const float needed = 8.0f * std::sqrt(0.05f / spacing) * 60.0f * timeStep;
    return static_cast<uint32_t>(std::clamp(std::ceil(needed - 0.01f), 4.0f, 16.0f));
}

Settings paperSettings()
{
    Settings s;
    s.solver = SolverKind::Paper;
    s.rotation = RotationMethod::Householder;
    s.grid = GridKind::Hash;
    s.reduction = ReductionKind::Steps;
    s.velocityOrder = VelocityOrder::First;
    s.substeps = 1;
    s.iterations = 4;
    s.stabilization = 1;
    s.contactMargin = 0.2f;
    s.freeze = 0.5f;
    s.virtualParticles = 0.01f;
    s.splitSharedMass = false;
    return s;
}

}  // namespace knuckle
