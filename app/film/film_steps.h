#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/film/moments.h"
#include "app/scene/scene_file.h"
#include "render/between_steps.h"
#include "sim/solver/solver.h"

namespace knuckle {

/// Brings a solver from frame to frame of a film, and shows the state that each frame is of: after a step, or between
/// two in slow and fast motion.
class FilmSteps {
public:
    /// @param scene, solver must outlive it.
    FilmSteps(const Gpu& gpu, const Scene& scene, Solver& solver);

    /// Takes the steps from the frame before to this one. @param step takes one.
    void advance(uint64_t frame, const std::function<void()>& step);
    /// Shows one of momentsBefore() a frame: its state, which is valid until the next call, and which it is.
    using ShowMoment = std::function<void(const ParticleView&, const Moment&, uint32_t index)>;
    /// The same, and shows moments on the way.
    void advance(uint64_t frame, const std::function<void()>& step, const ShowMoment& show);
    /// Of the last frame that advance() or goOn() have come to; the first before that.
    ParticleView view();
    /// The same on the host; stalls until the GPU is done.
    ViewState readView();
    uint64_t stateHash();
    /// What it needs to go on beside the solver's state; none: nothing.
    std::optional<BufferState> saveState() const;
    /// Goes on from a frame whose state the solver has. @throws std::logic_error for a state of another world.
    void goOn(uint64_t frame, const std::optional<BufferState>& state);

private:
    /// At a place counted in steps, not beyond the last one.
    ParticleView viewAt(double place, uint64_t steps);
    bool isBetween() const { return place_.part < 1.0; }

    const Scene& scene_;
    Solver& solver_;
    FramePlace place_;
    std::unique_ptr<BetweenSteps> between_;  ///< Null in a film at full speed without a shutter.
};

}  // namespace knuckle
