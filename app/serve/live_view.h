#pragma once

#include <string>

#include "app/scene/scene_file.h"
#include "app/serve/free_camera.h"
#include "render/renderer.h"

namespace knuckle {

/// Pictures of a live scene by its own camera, until viewers want to see it from elsewhere.
class LiveView {
public:
    /// @param view of the start. @throws as Renderer.
    LiveView(Gpu& gpu, const Scene& scene, const ParticleView& view);

    /// The camera as it stands at a time since the start [s].
    const FreeCamera& seenFrom(const ParticleView& view, double time);
    /// The same, which stands still from now on unless the viewer moves it.
    FreeCamera& steered(const ParticleView& view, double time);
    /// Back to where the scene's camera stood at the start.
    void goHome();
    /// A frame as JPEG; waits for it. @param time since the start [s].
    std::string draw(const ParticleView& view, double time);

private:
    RenderSettings settings_;
    Renderer renderer_;
    FreeCamera freeCamera(const ParticleView& view, double time);

    const World& world_;
    FreeCamera home_, camera_;
    bool isSteered_ = false;
};

/// How a scene is drawn live: by its first camera, with one draw a frame. @throws InputError for one that has none.
RenderSettings liveSettings(const Scene& scene);

}  // namespace knuckle
