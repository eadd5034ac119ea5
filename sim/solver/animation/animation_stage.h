#pragma once

#include "shared/animation_types.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// Bodies and colliders that clips move (World::animations, World::colliderMotions). All keys are uploaded once; the
/// number of the substep says where each clip is.
class AnimationStage : public Stage {
public:
    static bool isNeeded(const World& world) { return !world.animations.empty() || !world.colliderMotions.empty(); }
    explicit AnimationStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// At the start of a step of a world with fluids: how far colliders move in it.
    void lookAhead(Recorder& recorder) const;
    /// After the predictions: moves animated bodies and colliders to where clips have them at the substep's end.
    void animate(Recorder& recorder) const;

    Buffer<gpu::vec4> clipTurns;               ///< Per clip, key and body: its turn.
    Buffer<gpu::vec4> clipRoots;               ///< Per clip and key: where the pivot is [m].
    Buffer<gpu::AnimatedBody> animatedBodies;  ///< Grouped by animation, in the order of its object's bodies.
    Buffer<gpu::Animation> animations;         ///< Place of its object, and its plays; animations of colliders come
                                               ///< after those of objects.
    Buffer<gpu::ClipPlay> clipPlays;           ///< Per animation in order of time.
    Buffer<gpu::vec4> clipBodyTurns;           ///< Per animated body, if any is driven: its turn at the substep's end.
    Buffer<gpu::vec4> clipBodyPlaces;          ///< The same: its centre at that time [m], and its rotation.
    Buffer<gpu::MovingCollider> movingColliders;  ///< Where each stands in the frame that moves.
    Buffer<gpu::vec4> colliderFounds;  ///< Per moving collider: its place in the last search; w: the number of that
                                       ///< search.

private:
    void addBodies(const StageSetup& setup);
    void addColliders(const StageSetup& setup);

    const gpu::StepParameters& parameters_;
    bool hasBodies_, hasColliders_, hasFluids_;
    Pass animate_{*this, "animation/animate", {}, hasBodies_};
    Pass moveColliders_{*this, "animation/collider_move", {}, hasColliders_};
    Pass lookAhead_{*this, "animation/collider_move", {{"AHEAD", "1"}}, hasColliders_&& hasFluids_};
};

}  // namespace knuckle
