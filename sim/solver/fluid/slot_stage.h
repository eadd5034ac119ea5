#pragma once

#include "sim/solver/emitter/emitter_stage.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// A stage with kernels of one thread a slot of the fluids' grid.
class SlotStage : public Stage {
protected:
    explicit SlotStage(const StageSetup& setup)
        : parameters_(setup.parameters), hasPool_(EmitterStage::isNeeded(setup.world))
    {
    }

    void perSlot(Recorder& recorder, const Kernel& kernel) const
    {
        if (hasPool_) recorder.decided(kernel, DISPATCH_SLOTS);
        else recorder.perElement(kernel, parameters_.particleCount + parameters_.fluidCount);
    }

    const gpu::StepParameters& parameters_;
    bool hasPool_;  ///< The GPU decides how many slots there are.
};

}  // namespace knuckle
