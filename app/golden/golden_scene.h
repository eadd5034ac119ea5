#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/film/film_steps.h"
#include "app/golden/golden_file.h"
#include "app/golden/golden_states.h"
#include "app/run/interrupt.h"
#include "render/renderer.h"
#include "render/stored_view.h"

namespace knuckle {

/// A golden's scene, loaded, on a device.
class GoldenScene {
public:
    /// @param changes after the golden's own. @param gpu of this thread. @param interrupt is looked at after each
    /// frame.
    /// @throws InputError for a scene that is wrong, or too short for its frames.
    GoldenScene(const Golden& golden, const std::vector<Override>& changes, Gpu& gpu, const InterruptGuard& interrupt);

    const Scene& scene() const { return scene_; }
    RunFacts facts(const Golden& golden) const;

    /// What the device has at a frame.
    struct Simulated {
        uint64_t frame;
        FilmSteps& state;
        Renderer* camera;  ///< Has seen all frames before; null: none was asked for.
    };
    /// Simulates up to the last of `frames`, and shows each.
    /// @param withCamera whether a renderer sees all frames. @throws RunError, Interrupted.
    void simulate(const std::vector<uint64_t>& frames, bool withCamera,
                  const std::function<void(const Simulated&)>& show);

    /// What the scene has other numbers of than a stored state, so that it cannot be drawn; empty: nothing.
    std::string otherWorld(const ViewState& stored) const;
    /// The picture of a stored frame. @throws InputError where the scene is another world now.
    Image draw(const StoredFrame& frame);
    /// The same of another state, as the frame's camera sees it.
    Image draw(const StoredFrame& frame, const ViewState& view);

private:
    Scene scene_;
    Gpu& gpu_;
    StoredView stored_;
    std::optional<Renderer> renderer_;
    const InterruptGuard& interrupt_;
};

}  // namespace knuckle
