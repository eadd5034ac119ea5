#pragma once

#include <vector>

#include "shared/gpu_types.h"
#include "sim/solver/layout/joint_trees.h"
#include "sim/world/world.h"

namespace knuckle {

/// Places of everything of a World in the solver's arrays. Made from the World alone, before anything is uploaded, so
/// that uploads may happen in any order and read nothing back.
struct Layout {
    /// A link in the order of the GPU's array, and its body.
    struct Owner {
        uint32_t link = 0, body = 0;
    };

    explicit Layout(const World& world);

    uint32_t solidCount = 0;                 ///< Particles that are no fluid; they come first.
    uint32_t bodyCount = 0, looseCount = 0;  ///< Movers: bodies, then loose particles in the order of particles.
    uint32_t linkCount = 0;                  ///< Of bodies; those of clusters come after them.
    uint32_t assemblyCount = 0;              ///< Including one for each loose particle without an assembly.
    uint32_t moverCount() const { return bodyCount + looseCount; }
    /// Place of a body in heldBodies; NO_INDEX if it is not there.
    uint32_t heldIndex(uint32_t body) const;
    uint32_t colliderCount = 0;                           ///< Drains come after them.
    bool hasGrids = false;                                ///< Whether any collider is a grid.
    bool hasBoxRegions = false, hasRoundRegions = false;  ///< Whether any collider, drain or region of a release is a
                                                          ///< box; a sphere or a capsule.
    bool hasRounds = false;                               ///< Whether any body is a ball or a capsule.
    bool hasGrains = false;                               ///< Whether any particle has a size of its own.
    bool hasFlatFaces = false;                            ///< Whether any particle's lattice ends are known.

    std::vector<uint32_t> latticeEnds;      ///< Per particle: SurfaceDistance::ends of a body without joints; IN_ROUND.
    std::vector<uint32_t> assemblies;       ///< Per particle; NO_INDEX for fluids.
    std::vector<gpu::ParticleRank> ranks;   ///< Per solid particle.
    std::vector<uint32_t> rankedParticles;  ///< Per rank: the particle.
    std::vector<gpu::uvec2> moverRanks;     ///< Per mover: its first rank, and how many.
    std::vector<uint32_t> linkOrder;        ///< World::links in the GPU's order: a body's shared ones come last.
    std::vector<float> worstInverseMasses;  ///< Per World::links: see worstInverseMasses() [1/kg].
    std::vector<uint32_t> ownLinkCounts;    ///< Per body: links before the first shared one.
    std::vector<uint32_t> freeBodies, jointedBodies;  ///< Bodies that may respond, without joints and with.
    std::vector<uint32_t> firstAnimated;     ///< Per animation, its first body among all that clips move; then their
                                             ///< number.
    std::vector<uint32_t> heldBodies;        ///< Bodies that are held or animated and may be let go.
    std::vector<std::vector<Owner>> owners;  ///< Per particle: its links, in their order.
    std::vector<uint32_t> sharedParticles;   ///< Particles of two or more bodies, those of fewer bodies first.
    JointTrees jointTrees;

private:
    void assignAssemblies(const World& world);
    void rankParticles(const World& world);
    void orderLinks(const World& world);
    void listShared();
    void findShapes(const World& world);
    void findRegionShapes(const World& world);
};

}  // namespace knuckle
