#pragma once

#include "shared/step_parameters.h"
#include "sim/world/world.h"

namespace knuckle {

/// Sets the parameters of fluids, after those of the step.
void setFluidParameters(gpu::StepParameters& parameters, const World& world);

/// The one of them that gravity determines.
void setQuietSpeed(gpu::StepParameters& parameters);

/// Fluids of this viscosity and more are solved implicitly [Pa s].
inline constexpr float VISCOUS = 0.1f;

/// Whether a fluid is viscous enough for the implicit solve (ViscosityStage); it then sticks to walls and solids.
/// Thinner ones are smoothed once a step (fluid_viscosity.comp) and slip freely.
bool isViscous(const Material& material);

/// What kernels know of a material as a fluid (shaders/sim/fluid/fluid_materials.glsl).
gpu::vec4 fluidMaterial(const gpu::StepParameters& parameters, const Material& material, float timeStep);

/// What the implicit solve knows of a material (shaders/sim/fluid/viscous/viscous_materials.glsl).
gpu::vec4 viscousMaterial(const gpu::StepParameters& parameters, const Material& material);

/// As of slot_pressures.glsl [kg m2].
float lambdaUnit(const gpu::StepParameters& parameters);

/// Iterations that each of the two halves of the implicit solve needs in a world.
uint32_t viscousSweeps(const gpu::StepParameters& parameters, const World& world);

}  // namespace knuckle
