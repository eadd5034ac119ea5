#pragma once

#include "sim/solver/fluid/slot_stage.h"

namespace knuckle {

/// How particles of a fluid are drawn as parts of its surface, by how their neighbours lie around them. Nothing of the
/// simulation depends on it.
class FormStage : public SlotStage {
public:
    /// For worlds with a fluid that may be drawn as a surface.
    static bool isNeeded(const World& world);
    explicit FormStage(const StageSetup& setup) : SlotStage(setup) {}
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// Slots must be those that the step has listed.
    void endStep(Recorder& recorder) const { perSlot(recorder, form_); }

    Buffer<uint32_t> fluidForms;  ///< Per particle: packSpheroid() (math/spheroid.glsl); 0, INNER: balls.

private:
    Pass form_{*this, "fluid/fluid_form"};
};

}  // namespace knuckle
