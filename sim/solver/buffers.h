#pragma once

#include "shared/gpu_types.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/kernel.h"
#include "sim/world/world.h"

namespace knuckle {

/// What fluids need beside their particles. A slot is a particle's place in the order of the cells of the fluids' grid.
struct FluidBuffers {
    Buffer<gpu::vec4> fluidSearchPositions;             ///< Per particle: where it was when neighbours were found.
    Buffer<gpu::uvec2> fluidParticleCells;
    Buffer<uint32_t> fluidCellCounts, fluidCellSums, fluidCellStarts, fluidCellMembers;
    Buffer<gpu::uvec4> fluidSorted;                    ///< Per slot: the same, packed; four in an element.
    Buffer<uint32_t> slotParticles, particleSlots;     ///< Each other's inverse.
    Buffer<gpu::uvec2> slotCounts;                     ///< Fluid and solid neighbours.
    Buffer<gpu::uvec4> slotNeighbours;                 ///< fluidSlots a slot, sim/fluid/neighbour_lists.glsl.
    Buffer<uint32_t> slotColliders;                    ///< Bits: those nearby.
    Buffer<gpu::vec4> fluidMaterials;                  ///< Per material: smoothing, tension (upload_fluid.cpp).
    Buffer<gpu::vec4> slotVelocities;                  ///< When neighbours were found [m/s]; w: smoothing.
    Buffer<gpu::vec4> slotPositions;                      ///< Predicted [m].
    Buffer<gpu::vec4> slotPressures;                   ///< The same; w: lambda [kg m2].
    Buffer<uint32_t> slotMaterials;
    Buffer<gpu::vec4> slotVorticities;                 ///< [1/s]; w: its length.
    bool hasTension = false;
    Buffer<gpu::vec4> slotWalls, slotSolids;           ///< Gradients of what walls and solids add to the density.
};

/// Emitters, and the fluid particles that are parked until one of them takes them (shaders/sim/fluid/emitters.glsl).
struct PoolBuffers {
    Buffer<gpu::GpuEmitter> emitters;
    Buffer<gpu::EmitterState> emitterStates;           ///< Per emitter, within a step.
    Buffer<gpu::vec4> nozzlePoints;                    ///< Where layers leave [m].
    Buffer<uint32_t> poolOrder;                        ///< Halves: the particles of each pool, whose turn it is first.
    Buffer<uint32_t> poolInactive;                       ///< Per place in it: 1 if it was parked after the last step.
    Buffer<uint32_t> poolSums, poolChunks;             ///< Per chunk of it: parked before, emitter.
    Buffer<gpu::uvec2> fluidTotals;                    ///< Particles that came, that left.
};

/// Strands that are solved together.
struct DistanceColor {
    uint32_t begin = 0, end = 0;         ///< In SolverBuffers::distanceRows.
    bool hasBodies = false;              ///< Whether particles of bodies are among them.
};

/// A step of eq. 10: the links whose partial sum takes in another's.
struct ReductionStep {
    uint32_t begin = 0, end = 0;         ///< In SolverBuffers::reductionLinks.
    uint32_t stride = 1;                 ///< How many links on the other stands.
};

/// Everything that simulates, on the GPU: filled once from the World. A field's name is what kernels call it.
/// Per particle unless said otherwise.
struct SolverBuffers {
    // State.
    Buffer<gpu::vec4> positions, velocities;           ///< At the end of the last step [m], [m/s]; w: 1 if parked.
    // What never changes.
    Buffer<gpu::ParticleInfo> particleInfo;
    Buffer<gpu::uvec2> particleRanks;   ///< Mover, rank in the order of contact lists.
    Buffer<uint32_t> rankedParticles;    ///< Per rank: the particle.
    Buffer<gpu::vec4> masses;            ///< Inverse mass [1/kg], restitution, static, kinetic friction.
    Buffer<gpu::vec4> restPositions;     ///< In the assembly's rest pose [m]; w: margin of self-contact [diameters].
    Buffer<gpu::vec4> restOffsets;       ///< r in the first body [m]; w: the worst inverse mass in it [1/kg].
    Buffer<gpu::ParticleRigidBodyLink> links;          ///< Per link: the paper's listing 1.
    Buffer<float> linkMasses;            ///< Per link: worst inverse mass of its body at its particle [1/kg].
    Buffer<gpu::uvec2> particleLinks;    ///< First entry and count in linksOfParticle.
    Buffer<gpu::uvec2> linksOfParticle;  ///< Per link, grouped by particle: link, body.
    Buffer<gpu::BodyInfo> bodyInfo;      ///< Per body.
    Buffer<gpu::vec4> bodyMoments;       ///< Per body: columns of the sum of m r r^T [kg m2]; w of one: radius [m].
    Buffer<gpu::vec4> bodyInertias;      ///< Per body, two, inverse: xx, yy, zz, 1/mass; xy, xz, yz.
    Buffer<gpu::MoverInfo> moverInfo;    ///< Per mover.
    Buffer<uint32_t> moverStates;        ///< Per mover: MOVER_*.
    Buffer<uint32_t> sharedParticles;    ///< The particles of two or more bodies.
    Buffer<gpu::uvec4> sharedOwners;     ///< Of those of exactly two, which come first: link and body of each.
    Buffer<gpu::vec4> particleSurfaces;  ///< Way out of the first body, zero where none; w: distance to its surface.
    Buffer<uint32_t> latticeEnds;        ///< SurfaceDistance::ends of a body without joints, ALL_ENDS of all others.
    Buffer<gpu::GpuCollider> colliders;
    Buffer<float> gridValues;            ///< Of all ColliderGrids.
    Buffer<gpu::StepParameters> step;
    // Movers: bodies, then loose particles. Fields as in shaders/sim/common/fields.glsl.
    Buffer<gpu::vec4> moverCentres, moverRotations;    ///< c and Q: at the start of a substep, or (paper) now.
    Buffer<gpu::vec4> moverMoves, moverRotationDeltas;          ///< Since it began: of c [m], w: acting contacts; a quaternion.
    Buffer<gpu::vec4> moverVelocities, oldMoverVelocities, oldMoverMoves;   ///< Fields [m/s], [m/s], [m].
    Buffer<gpu::vec4> moverPredictions;                ///< Field: the untouched move, A of eq. 9 after it.
    Buffer<gpu::vec4> moverImpulses;                   ///< Field: what its contacts add to it [kg m].
    Buffer<gpu::vec4> moverChanges;                    ///< Field: how they last changed; w of the first: relaxation.
    /// Per particle, by rank: what acts on single particles, beside contacts and joints [kg m].
    Buffer<gpu::vec4> particleImpulses;
    // Restitution (shaders/sim/restitution/restitution.glsl), of a world that has any.
    Buffer<gpu::vec4> pairRestitutions, colliderRestitutions;    ///< As pairImpulses: the last change, all of it [kg m/s].
    Buffer<float> moverRestitutionSplits;                        ///< Per mover: over how many of them its mass is split.
    // Sleep (shaders/sim/common/sleep.glsl). Per assembly: steps that it was calm, name of its island.
    Buffer<gpu::uvec2> assemblyCalm, assemblyNext;
    Buffer<uint32_t> islandsWoken;                     ///< By name: 1 if something woke it in this step.
    Buffer<gpu::vec4> linkImpulses;                    ///< Per link: joints (joint_solve.comp) [kg m].
    Buffer<gpu::uvec2> assemblyState;    ///< Per assembly: last substep with a contact, order of this one.
    // Soft bodies (sim/solver/soft/upload_soft.h). Their links stand in `links` behind those of bodies.
    Buffer<gpu::ClusterInfo> clusterInfo;              ///< Per cluster.
    Buffer<gpu::vec4> clusterMoments;    ///< Per cluster, four: inverse moments; directions without particles.
    Buffer<gpu::GpuSoftMatter> softMatter;             ///< Per soft body.
    Buffer<gpu::uvec4> softParticles;    ///< Per soft particle: mover, rank, first entry and count in softLinks.
    Buffer<uint32_t> softLinks;          ///< Links of soft particles, grouped by particle.
    Buffer<gpu::vec4> clusterRotations;  ///< Per cluster: quaternion.
    Buffer<gpu::vec4> clusterRests;      ///< Per cluster: three columns of what it has flowed by.
    Buffer<gpu::vec4> clusterPulls;      ///< Per cluster, five: what pulls its particles (cluster_match.comp).
    Buffer<gpu::vec4> softImpulses;      ///< Per soft particle: from its clusters, in this substep [kg m].
    // The paper's solver, particle by particle.
    Buffer<gpu::vec4> oldMoves, oldVelocities;         ///< The last substep's move, the velocity before it: for BDF2.
    Buffer<gpu::vec4> predicted;         ///< Move since the substep began, x* - x.
    Buffer<gpu::vec4> moved;             ///< The same with what contacts ask for.
    Buffer<gpu::vec4> bodyStarts;        ///< Per body, two: centre and rotation when the substep began.
    Buffer<gpu::vec4> bodyMatrices;      ///< Per body: three columns of A.
    Buffer<gpu::uvec2> bodyActing;       ///< Per body: what moves it with the particles that contacts push, being
                                         ///< summed; of the last iteration (contact_average.comp).
    Buffer<float> linkGains;             ///< Per link of a shared particle: by how much further than the mean of goals
                                         ///< it stands in the match, in distances of goal and mean.
    Buffer<gpu::vec4> linkPulls;         ///< ... where that is from the mean [m].
    Buffer<gpu::vec4> linkTerms;         ///< Per link, three: eq. 10.
    Buffer<uint32_t> reductionLinks;     ///< Of each ReductionStep, one after another.
    // Ropes and cloth.
    Buffer<gpu::uvec4> distanceRows;          ///< First and last node, assembly.
    Buffer<gpu::uvec4> distanceNodes;      ///< Mover, rank, particle, inverse mass or split (distanceRows.glsl).
    Buffer<gpu::vec4> distanceLinks;       ///< Per node, to the next: rest length, compliance; force, length that tear.
    Buffer<gpu::vec4> distanceStates;      ///< Per node, to the next: multiplier [kg m], tension [N], 1 if torn.
    Buffer<gpu::vec4> distanceFactors;     ///< Per node, within a dispatch.
    // The neighbour grid.
    Buffer<gpu::vec4> calmCentres, calmRotations;      ///< Per mover: where its assembly counts its calm steps from.
    Buffer<gpu::vec4> searchPositions;    ///< Where a particle was when contacts were found.
    Buffer<gpu::vec4> searchCentres, searchRotations;    ///< Where a mover was then; w: how far it may drift [m].
    Buffer<float> moverReaches;          ///< Per mover: how much further it looks for contacts [m].
    Buffer<uint32_t> fastParticles;      ///< Those of movers that do.
    Buffer<uint32_t> moverColliders;     ///< Per mover, bits: colliders that it may touch.
    Buffer<gpu::uvec2> particleCells;
    Buffer<uint32_t> cellCounts, cellSums, cellStarts, cellMembers;   ///< Per cell, chunk, cell, particle.
    Buffer<gpu::vec4> sortedPositions;
    Buffer<gpu::uvec4> sortedInfos;      ///< Particle, assembly, rank, 1 if fast.
    // Lists of contacts (shaders/sim/common/contact_lists.glsl). "Halves": the current search and the one before.
    Buffer<gpu::uvec2> firstLists;       ///< As found, contactSlots a particle: second particle, its arrival there.
    Buffer<uint32_t> colliderLists;      ///< As found, COLLIDER_SLOTS a particle.
    Buffer<uint32_t> listCounts, listSums, listStarts; ///< Three lists of ranks; the last in halves.
    Buffer<gpu::uvec2> pairs;            ///< Halves of pairCapacity: first and second particle.
    Buffer<gpu::uvec4> pairSides;        ///< Per pair: movers (with a way out), frictions, shares of inverse masses and
                                         ///< hidden axes (shaders/sim/common/flat_faces.glsl).
    Buffer<gpu::vec4> pairArms;          ///< Per pair, two: place in the body, worst inverse mass there.
    Buffer<gpu::vec4> pairImpulses;      ///< Halves: the whole impulse, its normal part [kg m].
    Buffer<float> pairMeans;             ///< Halves: the mean of its normal part lately [kg m].
    Buffer<uint32_t> pairArrivals, pairReferences;     ///< Pairs by their second particle; the latter in order.
    Buffer<gpu::uvec2> colliderPairs;    ///< Halves of colliderPairCapacity: particle, collider.
    Buffer<gpu::uvec4> colliderSides;    ///< Per contact with a collider: mover, collider, frictions, share.
    Buffer<gpu::vec4> colliderArms, colliderImpulses;  ///< As for pairs.
    Buffer<float> colliderMeans;
    Buffer<gpu::uvec4> dispatches;       ///< DISPATCH_*.
    Buffer<gpu::Counters> counters;
    FluidBuffers fluid;
    PoolBuffers pool;

    gpu::StepParameters parameters{};    ///< The host's copy of `step`.
    bool hasRestitution = false;             ///< Whether any material has restitution.
    bool hasPool = false;                ///< Whether there are emitters, or drains of fluids.
    bool hasParticleImpulses = false;              ///< Whether anything but contacts and joints acts (particleImpulses).
    std::vector<DistanceColor> distanceColors;
    std::vector<uint32_t> distanceStarts;  ///< Per strand of the World, its first node; its last if that is fixed.
    bool hasGrids = false;               ///< Whether a collider is a mesh or a heightfield.
    std::vector<ReductionStep> reductionSteps;   ///< ceil(log2 p), p being the links of the largest body (eq. 10).

    /// Gives the lists of contacts the room that `parameters` asks for (contactSlots, pairCapacity,
    /// colliderPairCapacity); their contents are lost.
    /// @throws DeviceError when the device's limits are too small, with the number.
    void resizeContacts(const Gpu& gpu);
    BufferTable table();
};

/// Uploads the world. @throws DeviceError when the device's limits are too small for it, with the number.
SolverBuffers uploadWorld(const Gpu& gpu, const World& world);

}  // namespace knuckle
