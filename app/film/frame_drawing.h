#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/film/film_views.h"
#include "app/film/run_figures.h"
#include "app/scene/scene_file.h"
#include "app/states/run_state.h"
#include "render/frame_snapshot.h"
#include "render/output/frame_sink.h"
#include "render/output/task_thread.h"
#include "render/renderer.h"

namespace knuckle {

struct Frame {
    uint64_t number = 1;                ///< As in frame_0001.png.
    double time = 0.0;                  ///< [s]
    bool drawn = true;                  ///< Otherwise only the camera sees it.
    std::optional<uint32_t> draw = {};  ///< The one of drawsOf() that this is; none: all.
    PngText labels = {};                ///< Of its file.
};

using FrameSinks = std::vector<std::unique_ptr<FrameSink>>;

/// Draws the frames of all views of a run and hands their pictures to the views' sinks.
class FrameDrawing {
public:
    virtual ~FrameDrawing() = default;
    virtual void take(const ParticleView& view, const Frame& frame) = 0;
    /// During the next frame's steps: brings back the last picture, if no other thread does.
    virtual void fetch() = 0;
    /// Waits until the sinks have the pictures of all frames.
    virtual void wait() = 0;
    /// After wait().
    virtual const DrawingFigures& figures() const = 0;
    /// What the renderers carry on after the last frame taken; waits for it.
    virtual CameraStates saveState() = 0;
    /// Of those views that have one. @throws std::logic_error as Renderer::loadState().
    virtual void loadState(const CameraStates& states) = 0;
};

/// Draws on the thread that made it, which also simulates.
class DrawingHere : public FrameDrawing {
public:
    /// @param sinks of all outputs, as views name them. @param timed: every pass, see DrawingFigures.
    /// @throws what Renderer throws.
    DrawingHere(Gpu& gpu, const Scene& scene, const std::vector<FilmView>& views, const FrameSinks& sinks, bool timed);
    void take(const ParticleView& view, const Frame& frame) override;
    void fetch() override;
    void wait() override { fetch(); }
    const DrawingFigures& figures() const override { return figures_; }
    CameraStates saveState() override;
    void loadState(const CameraStates& states) override;

private:
    struct View {
        View(Gpu& gpu, const World& world, const FilmView& view);

        std::string camera;
        std::vector<FrameSink*> sinks = {};
        uint32_t draws;  ///< Of a frame.
        Renderer renderer;
        std::optional<Frame> unread = {};  ///< The frame drawn last.
    };
    /// @returns whether a picture is finished.
    static bool take(View& own, const ParticleView& view, const Frame& frame);
    void fetch(View& own);

    Gpu& gpu_;
    std::vector<std::unique_ptr<View>> views_;
    DrawingFigures figures_;
};

/// Draws on a separate thread and context, from copies, while the caller continues to simulate. The next call throws
/// errors that happen there.
class DrawingThread : public FrameDrawing {
public:
    /// Waits until the thread can draw. @throws as DrawingHere, and DeviceError if there is no second context.
    DrawingThread(const Gpu& gpu, const Scene& scene, const std::vector<FilmView>& views, const FrameSinks& sinks,
                  bool timed);
    /// Copies the state; waits for the frame before the last.
    void take(const ParticleView& view, const Frame& frame) override;
    void fetch() override {}
    void wait() override { thread_.drain(); }
    const DrawingFigures& figures() const override { return drawing_->figures(); }
    CameraStates saveState() override;
    void loadState(const CameraStates& states) override;

private:
    /// One is drawn, the next one waits.
    static constexpr size_t SNAPSHOTS = 2;

    std::array<FrameSnapshot, SNAPSHOTS> snapshots_;
    size_t next_ = 0;
    std::unique_ptr<Gpu> gpu_;  ///< Current on the thread.
    /// Made, used and destroyed on the thread; a caller that has waited for it may read figures.
    std::unique_ptr<DrawingHere> drawing_;
    TaskThread thread_;
};

}  // namespace knuckle
