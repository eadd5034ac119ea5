#pragma once

#include <span>

#include "sim/solver/buffers.h"

namespace knuckle {

/// The numbers of the paper's solver that the paper leaves open (docs/physics.md has the figures that decided them).
void setPaperParameters(gpu::StepParameters& p, const World& world);

/// Buffers of the paper's solver, after the links.
/// @param inverseMasses per link in the GPU's order: of its body at the particle [1/kg].
void makePaper(SolverBuffers& out, const World& world, std::span<const gpu::ParticleRigidBodyLink> links,
               std::span<const float> inverseMasses);

}  // namespace knuckle
