#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Restitution (shaders/sim/restitution/restitution.glsl): after a substep, the speeds with which collisions part.
class RestitutionStage : public Stage {
public:
    /// Whether any material of the world has restitution.
    static bool isNeeded(const World& world);
    explicit RestitutionStage(const StageSetup& setup);
    void addBuffers(BufferTable& table) override;
    void grow(const Gpu& gpu, gpu::StepParameters& parameters, const gpu::Counters& counters) override;

    void apply(Recorder& recorder) const;

    Buffer<gpu::vec4> pairRestitutions, colliderRestitutions;  ///< As pairImpulses: last change, all of it [kg m/s].
    Buffer<float> moverRestitutionSplits;                      ///< Per mover: over how many of them its mass is split.

private:
    void makeLists();
    void iterate(Recorder& recorder, const Kernel& pairs, const Kernel& colliders) const;

    const gpu::StepParameters& parameters_;
    bool hasColliders_;
    Pass detectPairs_{*this, "restitution/contact_restitution", {{"DETECT", "1"}}};
    Pass detectColliders_{*this, "restitution/collider_restitution", {{"DETECT", "1"}}, hasColliders_};
    Pass solvePairs_{*this, "restitution/contact_restitution"};
    Pass solveColliders_{*this, "restitution/collider_restitution", {}, hasColliders_};
    Pass solvePairsEagerly_{*this, "restitution/contact_restitution", {{"EAGER", "1"}}};
    Pass solveCollidersEagerly_{*this, "restitution/collider_restitution", {{"EAGER", "1"}}, hasColliders_};
    Pass movers_{*this, "restitution/mover_restitution"};
};

}  // namespace knuckle
