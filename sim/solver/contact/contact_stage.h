#pragma once

#include "shared/counters.h"
#include "sim/solver/measure/contact_force.h"
#include "sim/solver/search/search_stage.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// Contacts between particles and with colliders: their data and their impulses. "Halves" as in SearchStage.
class ContactStage : public Stage {
public:
    explicit ContactStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;
    void makeLists() override;

    /// Fills in the data of a new search's contacts, and gives them their old impulses.
    void prepare(Recorder& recorder) const;
    /// One iteration of the impulses.
    void solve(Recorder& recorder) const;

    /// All contacts that act, in the order of the lists. Stalls until the GPU is done.
    std::vector<ContactForce> forces(const SearchStage& search, const gpu::Counters& counters) const;

    Buffer<gpu::uvec4>
        pairSides;               ///< Per pair: movers (with an exit direction), frictions, fractions of inverse masses
                                 ///< and hidden axes (shaders/sim/common/contacts/flat_faces.glsl).
    Buffer<gpu::vec4> pairArms;  ///< Per pair, two: place in the body, worst inverse mass there.
    Buffer<gpu::vec4> pairImpulses;    ///< Halves: the whole impulse, its normal part [kg m].
    Buffer<float> pairMeans;           ///< Halves: the recent mean of its normal part [kg m].
    Buffer<gpu::vec4> grainFrictions;  ///< Per material: static and kinetic between two grains.
    Buffer<gpu::uvec4> colliderSides;  ///< Per contact with a collider: mover, collider, frictions, fraction.
    Buffer<gpu::vec4> colliderArms, colliderImpulses;  ///< As for pairs.
    Buffer<float> colliderMeans;                       ///< As for pairs.

private:
    void setParameters(const StageSetup& setup);

    const gpu::StepParameters& parameters_;
    bool byImpulses_, hasSolids_, hasColliders_;
    Pass preparePairs_{*this, "contact/contact_prepare", {}, hasSolids_};
    Pass prepareColliders_{*this, "contact/collider_prepare", {}, hasColliders_};
    Pass solvePairs_{*this, "contact/contact_solve", {}, hasSolids_&& byImpulses_};
    Pass solveColliders_{*this, "contact/collider_solve", {}, hasColliders_&& byImpulses_};
};

}  // namespace knuckle
