#pragma once

#include "shared/animation_types.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// Bodies that clips move (World::animations). All keys are uploaded once; where a clip is follows from the number of
/// the substep.
class AnimationStage : public Stage {
public:
    static bool isNeeded(const World& world) { return !world.animations.empty(); }
    explicit AnimationStage(const StageSetup& setup) : parameters_(setup.parameters) {}
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// After the predictions: how far animated bodies come in the substep.
    void animate(Recorder& recorder) const;

    Buffer<gpu::vec4> clipTurns;               ///< Per clip, key and body: its turn.
    Buffer<gpu::vec4> clipRoots;               ///< Per clip and key: where the pivot is [m].
    Buffer<gpu::AnimatedBody> animatedBodies;  ///< Grouped by animation, in the order of its object's bodies.
    Buffer<gpu::GpuAnimation> animations;      ///< Where its object stands, and its plays.
    Buffer<gpu::GpuClipPlay> clipPlays;        ///< Per animation in order of time.
    Buffer<gpu::vec4> clipBodyTurns;   ///< Per animated body, where any is driven: its turn at the substep's end.
    Buffer<gpu::vec4> clipBodyPlaces;  ///< The same: where its centre is then [m], and its rotation.

private:
    const gpu::StepParameters& parameters_;
    Pass animate_{*this, "animation/animate"};
};

}  // namespace knuckle
