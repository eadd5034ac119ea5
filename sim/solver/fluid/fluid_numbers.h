#pragma once

#include "shared/step_parameters.h"
#include "sim/world/world.h"

namespace knuckle {

/// Sets the parameters of fluids, after those of the step.
void setFluidParameters(gpu::StepParameters& parameters, const World& world);

/// Whether a fluid is viscous enough for the implicit solve (ViscosityStage); it then sticks to walls and solids.
/// Thinner ones are smoothed once a step (fluid_viscosity.comp) and slip freely.
bool isViscous(const Material& material);

/// The part of the difference to its neighbours that a fluid of the material loses in a step (fluid_viscosity.comp).
float smoothing(const gpu::StepParameters& parameters, const Material& material, float time);

/// What the implicit solve knows of a material (shaders/sim/fluid/viscous/viscous_materials.glsl).
gpu::vec4 viscousMaterial(const gpu::StepParameters& parameters, const Material& material);

/// Iterations that each of the two halves of the implicit solve needs in a world.
uint32_t viscousSweeps(const gpu::StepParameters& parameters, const World& world);

/// Two particles that attract each other get this times fluidAttraction(q) of fluid.glsl in a substep [kg m].
float tension(const gpu::StepParameters& parameters, const Material& material);

}  // namespace knuckle
