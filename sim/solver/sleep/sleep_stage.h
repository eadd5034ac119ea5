#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Sleep of islands (Settings::sleepSpeed), or freezing of single assemblies (Settings::freeze); see
/// shaders/sim/sleep/calm.glsl.
class SleepStage : public Stage {
public:
    static bool isNeeded(const Settings& settings) { return settings.sleepSpeed > 0.0f || settings.freeze > 0.0f; }
    explicit SleepStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// Wakes what a moving assembly comes near, in each substep after the search.
    void wake(Recorder& recorder) const;
    /// Puts to sleep or freezes what has been calm for long: at a step's end, when particles are placed.
    void endStep(Recorder& recorder) const;

    Buffer<gpu::uvec2> assemblyCalm, assemblyNext;  ///< Per assembly: number of calm steps, name of its island.
    Buffer<uint32_t> islandsWoken;                  ///< By name: 1 if something woke it in this step.
    Buffer<gpu::uvec2> sleepReleases;               ///< Of joints and ropes that let go: assembly, substep.
    Buffer<gpu::vec4> calmCentres, calmRotations;   ///< Per mover: where its assembly began to count its calm steps.

private:
    const gpu::StepParameters& parameters_;
    bool freezes_, meetsMoving_, hasMotors_, letsGo_;
    Pass wakeIsland_{*this, "sleep/sleep_wake_island"};
    Pass wakeByCollider_{*this, "sleep/sleep_collider", {{"WAKE", "1"}}, meetsMoving_};
    Pass wakeAssembly_{*this, "sleep/sleep_wake_assembly"};
    Pass wakeMovers_{*this, "sleep/sleep_state"};
    Pass rest_{*this, "sleep/sleep_state"};
    Pass besideCollider_{*this, "sleep/sleep_collider", {}, meetsMoving_};
    Pass sleepMover_{*this, "sleep/sleep_mover", {}, !freezes_};
    Pass sleepIsland_{*this, "sleep/sleep_island", {}, !freezes_};
    Pass sleepUpdate_{*this, "sleep/sleep_update", {}, !freezes_};
    Pass motor_{*this, "sleep/sleep_motor", {}, hasMotors_};
    Pass release_{*this, "sleep/sleep_release", {}, letsGo_};
    Pass freezeMover_{*this, "sleep/freeze_mover", {}, freezes_};
    Pass freezeUpdate_{*this, "sleep/freeze_update", {}, freezes_};
};

}  // namespace knuckle
