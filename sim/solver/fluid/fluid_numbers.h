#pragma once

#include "shared/step_parameters.h"
#include "sim/world/world.h"

namespace knuckle {

/// Sets the parameters of fluids, after those of the step.
void setFluidParameters(gpu::StepParameters& parameters, const World& world);

/// How much of the difference to its neighbours a fluid of the material gives up in a step (fluid_viscosity.comp).
float smoothing(const gpu::StepParameters& parameters, const Material& material, float time);

/// What two particles that attract each other get in a substep is this times fluidAttraction(q) of fluid.glsl [kg m].
float tension(const gpu::StepParameters& parameters, const Material& material);

}  // namespace knuckle
