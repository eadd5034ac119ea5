#pragma once

#include "shared/step_parameters.h"
#include "sim/world/world.h"

namespace knuckle {

/// Sets the parameters of fluids, after those of the step.
void setFluidParameters(gpu::StepParameters& parameters, const World& world);

/// The part of the difference to its neighbours that a fluid of the material loses in a step (fluid_viscosity.comp).
float smoothing(const gpu::StepParameters& parameters, const Material& material, float time);

/// Two particles that attract each other get this times fluidAttraction(q) of fluid.glsl in a substep [kg m].
float tension(const gpu::StepParameters& parameters, const Material& material);

}  // namespace knuckle
