#pragma once

#include <string>

#include "app/scene/scene_file.h"
#include "app/serve/free_camera.h"
#include "render/renderer.h"

namespace knuckle {

/// Pictures of a live scene from where its viewers want to see it. It begins where the scene's camera stands.
class LiveView {
public:
    /// @param view of the start. @throws as Renderer.
    LiveView(Gpu& gpu, const Scene& scene, const ParticleView& view);

    FreeCamera& camera() { return camera_; }
    /// Back to where the scene's camera stood.
    void goHome() { camera_ = home_; }
    /// A frame as JPEG; waits for it. @param time since the start [s].
    std::string draw(const ParticleView& view, double time);

private:
    RenderSettings settings_;
    Renderer renderer_;
    FreeCamera home_, camera_;
};

/// How a scene is drawn live: by its first camera, with one draw a frame. @throws InputError for one that has none.
RenderSettings liveSettings(const Scene& scene);

}  // namespace knuckle
