#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Which particles may touch: the neighbour grid, and the lists of contacts
/// (shaders/sim/common/contacts/contact_lists.glsl). It searches only when something has left its margin, which kernels
/// decide. "Halves": of the current search and the previous one.
class SearchStage : public Stage {
public:
    explicit SearchStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;
    void reserve(gpu::StepParameters& parameters, const gpu::Counters& counters) const override;

    /// Makes the lists anew, with the capacities of the parameters. @throws DeviceError for more movers than contacts
    /// have numbers for.
    void makeLists() override;
    /// Counts the substep. In a world without solid particles this is the whole search.
    void count(Recorder& recorder) const;
    /// Finds contacts and lists pairs; ContactStage prepares their data.
    void find(Recorder& recorder) const;

    Buffer<gpu::vec4> searchPositions;                 ///< Per particle: the position for which contacts were found.
    Buffer<gpu::vec4> searchCentres, searchRotations;  ///< The same for a mover; w: how far it may drift [m].
    Buffer<float> moverReaches;                        ///< Per mover: how much further it looks for contacts [m].
    Buffer<uint32_t> fastParticles;                    ///< Particles of movers that look further.
    Buffer<uint32_t> moverColliders;                   ///< Per mover, bits: colliders that it may touch.
    Buffer<gpu::uvec2> particleCells;                  ///< Cell, arrival in it.
    Buffer<uint32_t> cellCounts, cellSums, cellStarts, cellMembers;  ///< Per cell, chunk, cell, particle.
    Buffer<gpu::vec4> sortedPositions;                  ///< In the order of cells; w: bits of the mover's index.
    Buffer<uint32_t> sortedParticles;                   ///< Twice the particle's index, and 1 if it is fast.
    Buffer<gpu::uvec4> candidates;                      ///< Contacts as they are found: first, second, place, arrival.
    Buffer<uint32_t> listCounts, listSums, listStarts;  ///< Three lists by rank; the last in halves.
    Buffer<gpu::uvec2> pairs;                           ///< Halves of pairCapacity: first and second particle.
    Buffer<uint32_t> pairArrivals, pairReferences;      ///< By second particle, as they were found and in order.
    Buffer<gpu::uvec2> colliderPairs;                   ///< Halves of colliderPairCapacity: particle, collider.
    Buffer<gpu::uvec4> bodyFilters;  ///< Per body: its first bit in filterBits; first and end of its object's bodies.
    Buffer<uint32_t> filterBits;     ///< A bit a body and body of its object: they never touch (Body::filtered).

private:
    void uploadFilters(const World& world);
    void setParameters(const StageSetup& setup);
    void makeGrid(gpu::StepParameters& parameters);

    const gpu::StepParameters& parameters_;
    /// The first: the solver is the paper's, whose bodies are particles until the end of a step.
    bool byParticles_, hasSolids_, hasColliders_;
    Defines kind_ = byParticles_ ? Defines{{"FROM_POSITIONS", "1"}} : Defines{};
    Pass drift_{*this, "search/mover_drift", {}, hasSolids_ && !byParticles_};
    Pass due_{*this, "search/search_due"};
    Pass reach_{*this, "search/mover_reach", {}, hasSolids_ && !byParticles_};
    Pass centre_{*this, "search/search_centre", kind_, hasSolids_};
    Pass position_{*this, "search/search_position", kind_, hasSolids_};
    Pass countCells_{*this, "common/grid/grid_count", {}, hasSolids_};
    Pass cellSum_{*this, "common/grid/scan_sum", {}, hasSolids_};
    Pass cellStart_{*this, "common/grid/grid_start", {}, hasSolids_};
    Pass scatter_{*this, "common/grid/grid_scatter", {}, hasSolids_};
    Pass order_{*this, "search/grid_order", {}, hasSolids_};
    Pass find_{*this, "search/contact_find", {}, hasSolids_};
    Pass findFar_{*this, "search/contact_find_far", {}, hasSolids_};
    Pass colliderNear_{*this, "search/collider_near", {}, hasColliders_ && !byParticles_};
    Pass colliderFind_{*this, "search/collider_find", {}, hasColliders_};
    Pass listSum_{*this, "common/grid/scan_sum", {{"LISTS", "1"}}, hasSolids_};
    Pass listStart_{*this, "search/list_start", {{"LISTS", "1"}}, hasSolids_};
    Pass list_{*this, "search/pair_list", {}, hasSolids_};
};

}  // namespace knuckle
