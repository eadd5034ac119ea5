#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

#include "app/scene/scene_file.h"
#include "app/serve/free_camera.h"
#include "app/serve/web/live_feed.h"
#include "render/frame_snapshot.h"
#include "render/output/task_thread.h"
#include "render/renderer.h"

namespace knuckle {

/// Draws a live scene on a thread and a context of its own, from copies of the state, while the simulation goes on.
/// Where the driver gives no second context, it draws on the caller's thread.
class LiveDrawing {
public:
    /// Waits until it can draw. @param feed gets pictures as JPEG, and is woken after each. @throws as Renderer.
    LiveDrawing(Gpu& gpu, const Scene& scene, const ParticleView& view, LiveFeed& feed);
    ~LiveDrawing() = default;
    LiveDrawing(const LiveDrawing&) = delete;
    LiveDrawing& operator=(const LiveDrawing&) = delete;

    /// Whether the last picture is finished.
    bool isIdle() const { return idle_; }
    /// Copies a state and begins to draw it. @param time since the start [s]. @param camera of viewers; none: the
    /// scene's own. @throws what went wrong with an earlier picture.
    void draw(const ParticleView& view, double time, const std::optional<FreeCamera>& camera);
    /// The scene's own camera shows a state, without a picture; waits for it.
    void look(const ParticleView& view, double time);
    /// Where the scene's own camera stood at last, and at the start.
    FreeCamera camera() const;
    const FreeCamera& home() const { return home_; }
    /// How long the last picture took, with its JPEG [s].
    double seconds() const { return seconds_; }

private:
    void run(TaskThread::Task task);
    void noteCamera();

    const World& world_;
    RenderSettings settings_;
    LiveFeed& feed_;
    FrameSnapshot snapshot_;
    FreeCamera camera_, home_;
    mutable std::mutex mutex_;  ///< Of camera_.
    std::atomic<bool> idle_ = true;
    std::atomic<double> seconds_ = 0.0;
    std::unique_ptr<Gpu> gpu_;            ///< Current on the thread, if there is one.
    std::unique_ptr<Renderer> renderer_;  ///< Made, used and destroyed there.
    std::unique_ptr<TaskThread> thread_;
};

/// How a scene is drawn live: by its first camera, with one draw a frame. @throws InputError for one that has none.
RenderSettings liveSettings(const Scene& scene);

}  // namespace knuckle
