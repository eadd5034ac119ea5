#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Particles: their positions, and what never changes about them. It has no kernels; bodies and fluids move them.
class ParticleStage : public Stage {
public:
    explicit ParticleStage(const StageSetup&) {}
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    Buffer<gpu::vec4> positions, velocities;  ///< At the end of the last step [m], [m/s]; w: 1 if inactive.
    Buffer<gpu::Particle> particleInfo;       ///< What never changes about each.
    Buffer<gpu::uvec2> particleRanks;         ///< gpu::ParticleRank, of solid particles.
    Buffer<uint32_t> rankedParticles;         ///< Per rank: the particle.
    Buffer<gpu::vec4> masses;                 ///< Inverse mass [1/kg], restitution, static, kinetic friction.
    Buffer<gpu::vec4> restPositions;  ///< In the assembly's rest pose [m]; w: margin of self-contact [diameters].
    Buffer<gpu::vec4> restOffsets;    ///< r in the first body [m]; w: the worst inverse mass in it [1/kg].
    Buffer<gpu::vec4>
        particleSurfaces;          ///< Exit direction of the first body, zero where none; w: distance to its surface.
    Buffer<uint32_t> latticeEnds;  ///< SurfaceDistance::ends of a body without joints, ALL_ENDS of others; IN_ROUND.
    Buffer<gpu::uvec2> assemblyState;  ///< Per assembly: last substep with a contact, order of this one.

private:
    void uploadConstants(const StageSetup& setup);
    void uploadRestOffsets(const StageSetup& setup);
};

}  // namespace knuckle
