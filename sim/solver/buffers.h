#pragma once

#include "shared/gpu_types.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/kernel.h"
#include "sim/world/world.h"

namespace knuckle {

/// Everything that simulates, on the GPU: filled once from the World. A field's name is what kernels call it.
/// Per particle unless said otherwise.
struct SolverBuffers {
    // State.
    Buffer<gpu::vec4> positions, velocities;           ///< At the end of the last substep [m], [m/s].
    Buffer<gpu::vec4> oldMoves, oldVelocities;         ///< The last substep's move, the velocity before it: for BDF2.
    Buffer<gpu::vec4> bodyCentres, bodyRotations;      ///< Per body: c and Q.
    // What never changes.
    Buffer<gpu::ParticleInfo> particleInfo;
    Buffer<gpu::vec4> masses;            ///< Inverse mass [1/kg], unused, static and kinetic friction.
    Buffer<gpu::vec4> restPositions;     ///< In the assembly's rest pose [m].
    Buffer<gpu::vec4> restOffsets;       ///< r in the first body [m]; w: effective inverse mass in it [1/kg].
    Buffer<gpu::ParticleRigidBodyLink> links;          ///< Per link: the paper's listing 1.
    Buffer<float> linkMasses;            ///< Per link: effective inverse mass of its body at its particle [1/kg].
    Buffer<gpu::uvec2> particleLinks;    ///< First entry and count in linksOfParticle.
    Buffer<gpu::uvec2> linksOfParticle;  ///< Per link, grouped by particle: link, body.
    Buffer<gpu::BodyInfo> bodyInfo;      ///< Per body.
    Buffer<uint32_t> bodyAssemblies;     ///< Per body.
    Buffer<uint32_t> sharedParticles;    ///< The particles of two or more bodies.
    Buffer<gpu::GpuCollider> colliders;
    Buffer<gpu::StepParameters> step;
    // Within a substep.
    Buffer<gpu::vec4> predicted;         ///< Move since the substep began, x* - x; w: inverse mass as contacts feel it.
    Buffer<gpu::vec4> moved;             ///< The same with the contacts' impulses as displacements; w: acting contacts.
    Buffer<gpu::vec4> bodyStarts;        ///< Per body, two: centre and rotation when the substep began.
    Buffer<gpu::vec4> bodyTurns;         ///< Per body: the turn since the substep began, a quaternion.
    Buffer<gpu::vec4> bodyMoves;         ///< Per body: the centre's move since; w: acting contacts.
    Buffer<gpu::vec4> stabilized;        ///< Paper solver only.
    Buffer<gpu::vec4> linkOffsets, linkGaps;           ///< Per link: joints as impulses (joint_goals.comp).
    Buffer<gpu::vec4> bodyMatrices;      ///< Per body: three columns of A.
    Buffer<gpu::vec4> linkTerms;         ///< Per link, three: the paper's reduction only.
    Buffer<gpu::uvec2> assemblyState;    ///< Per assembly: last substep with a contact, order of this one.
    // Grid and candidates.
    Buffer<gpu::vec4> foundPositions;    ///< Where a particle was when its candidates were found.
    Buffer<gpu::uvec2> particleCells;
    Buffer<uint32_t> cellCounts, chunkSums, cellStarts, cellMembers;   ///< Per cell, chunk, cell, particle.
    Buffer<gpu::vec4> sortedPositions;
    Buffer<uint32_t> sortedIds;
    Buffer<uint32_t> candidates;         ///< Two halves of contactSlots + COLLIDER_SLOTS a particle.
    Buffer<gpu::vec4> impulses;          ///< The same shape: tangential in xyz, normal in w [kg m].
    Buffer<gpu::uvec2> candidateCounts;  ///< Two a particle: particles, colliders.
    Buffer<gpu::uvec4> dispatches;
    Buffer<gpu::Counters> counters;

    gpu::StepParameters parameters{};    ///< The host's copy of `step`.
    uint32_t longestBody = 0;            ///< Links of the largest body (p of eq. 10).

    /// Gives the candidate lists room for `slots` a particle; their contents are lost.
    /// @throws DeviceError when the device's limits are too small, with the number.
    void resizeContacts(const Gpu& gpu, uint32_t slots);
    BufferTable table();
};

/// Uploads the world. @throws DeviceError when the device's limits are too small for it, with the number.
SolverBuffers uploadWorld(const Gpu& gpu, const World& world);

}  // namespace knuckle
