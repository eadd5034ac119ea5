#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Restitution (shaders/sim/restitution/restitution.glsl): after a substep, gives collisions their speeds of
/// separation.
class RestitutionStage : public Stage {
public:
    /// Whether any material of the world has restitution.
    static bool isNeeded(const World& world);
    explicit RestitutionStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void adapt(gpu::StepParameters& parameters) override;
    void addBuffers(BufferTable& table) override;
    void makeLists() override;

    void apply(Recorder& recorder) const;

    Buffer<gpu::vec4> pairRestitutions, colliderRestitutions;  ///< As pairImpulses: the last change and the sum [kg
                                                               ///< m/s].
    Buffer<gpu::vec4> pairLedgers, colliderLedgers;            ///< Energy: linear and square gain, what the first side
                                                               ///< may give back beyond its loss [J].
    Buffer<gpu::vec4> moverSolvedVelocities;                   ///< Velocity fields without bounces [m/s].
    Buffer<float> moverRestitutionSplits;                      ///< Per mover: number of collisions' impulses over which
                                                               ///< its mass is split; REACHED (blows.glsl).
    Buffer<gpu::vec4> moverRestitutionShares;                  ///< Per mover: the shares of these impulses and of the
                                                               ///< solver's impulses that its energy affords.
    Buffer<uint32_t> lastCollision;                            ///< The last substep in which anything collided.
    Buffer<gpu::uvec4> restitutionSizes;                       ///< Work groups of what lets it bounce.

private:
    void iterate(Recorder& recorder, const Kernel& pairs, const Kernel& colliders, const Kernel& movers) const;

    const gpu::StepParameters& parameters_;
    uint32_t iterations_;  // of the solver: as many contacts a blow passes in a substep
    bool hasColliders_;
    Pass detectPairs_{*this, "restitution/contact_restitution", {{"DETECT", "1"}}};
    Pass detectColliders_{*this, "restitution/collider_restitution", {{"DETECT", "1"}}, hasColliders_};
    Pass solvePairs_{*this, "restitution/contact_restitution"};
    Pass solveColliders_{*this, "restitution/collider_restitution", {}, hasColliders_};
    Pass solvePairsEagerly_{*this, "restitution/contact_restitution", {{"EAGER", "1"}}};
    Pass solveCollidersEagerly_{*this, "restitution/collider_restitution", {{"EAGER", "1"}}, hasColliders_};
    Pass pairLedgers_{*this, "restitution/contact_restitution", {{"LEDGER", "1"}}};
    Pass colliderLedgers_{*this, "restitution/collider_restitution", {{"LEDGER", "1"}}, hasColliders_};
    Pass sharePairs_{*this, "restitution/contact_restitution", {{"SHARE", "1"}}};
    Pass shareColliders_{*this, "restitution/collider_restitution", {{"SHARE", "1"}}, hasColliders_};
    Pass countMovers_{*this, "restitution/mover_restitution", {{"DETECT", "1"}}};
    Pass due_{*this, "restitution/restitution_due"};
    Pass takeBack_{*this, "restitution/contact_take_back"};
    Pass reachMovers_{*this, "restitution/mover_restitution", {{"REACH", "1"}}};
    Pass beginMovers_{*this, "restitution/mover_restitution", {{"BEGIN", "1"}}};
    Pass moveMovers_{*this, "restitution/mover_restitution"};
    Pass moverShares_{*this, "restitution/mover_share"};
};

}  // namespace knuckle
