#pragma once

#include "shared/force_types.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// Accelerations from outside other than gravity: wind and force fields (World::wind, World::forceFields). Kernels get
/// a mover's whole acceleration from outsideAcceleration() (shaders/sim/common/outside.glsl).
class ForceStage : public Stage {
public:
    static bool isNeeded(const World& world) { return hasForces(world); }
    explicit ForceStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void adapt(gpu::StepParameters& parameters) override;
    void addBuffers(BufferTable& table) override;

    /// At the start of a substep: computes how movers are accelerated in it.
    void find(Recorder& recorder) const;
    /// At its end: accelerates fluids.
    void actOnFluids(Recorder& recorder) const;

    Buffer<gpu::ForceField> forceFields;
    Buffer<gpu::GustWave> gustWaves;
    Buffer<gpu::vec4> moverDrags;          ///< From dragsOf() [1/m].
    Buffer<gpu::uvec2> clothRanges;        ///< Per loose mover, if there is cloth: its first triangle, how many.
    Buffer<gpu::uvec4> clothTriangles;     ///< Particles of a triangle's corners, listed once for each loose corner.
    Buffer<gpu::vec4> moverAccelerations;  ///< Gravity's, fields' and the air's in this substep [m/s2].

private:
    void uploadCloth(const StageSetup& setup);

    const gpu::StepParameters& parameters_;
    Wind wind_;  ///< Of the world.
    bool hasMovers_, hasFluids_, hasCloth_;
    Pass movers_{*this, "forces/mover_forces", definesOf({{"CLOTH", hasCloth_}}), hasMovers_};
    Pass fluids_{*this, "fluid/fluid_forces", {}, hasFluids_};
};

}  // namespace knuckle
