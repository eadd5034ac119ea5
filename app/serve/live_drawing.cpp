#include "app/serve/live_drawing.h"

#include <algorithm>
#include <utility>

#include "app/run/stopwatch.h"
#include "render/view/camera.h"
#include "render/view/framed_sets.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr int JPEG_QUALITY = 80;

/// How far in front of a camera the middle of the scene is [m].
float distanceOf(const World& world, const LayerCamera& camera)
{
    const SceneExtent extent = sceneExtent(world);
    const Eigen::Vector3d middle = extent.stage.center().cast<double>();
    const double depth = -(camera.toWorld.inverse() * middle).z();
    return static_cast<float>(std::max(depth, 0.1 * static_cast<double>(extent.size)));
}

}  // namespace

RenderSettings liveSettings(const Scene& scene)
{
    RenderSettings settings = scene.render;
    settings.camera = shotsOf(settings).front().camera;
    settings.camera.aperture = 0.0f;
    settings.camera.focused.clear();
    settings.camera.roll = 0.0f;
    if (!settings.camera.keys.empty()) settings.camera.fieldOfView = settings.camera.keys.front().fieldOfView;
    for (CameraKey& key : settings.camera.keys) key.aperture = 0.0f;
    settings.shots.clear();
    settings.samples = 1;
    settings.shutter = 0.0f;
    settings.depth = 8;
    return settings;
}

LiveDrawing::LiveDrawing(Gpu& gpu, const Scene& scene, const ParticleView& view, LiveFeed& feed)
    : world_(scene.world), settings_(liveSettings(scene)), feed_(feed), snapshot_(world_, {settings_})
{
    try {
        gpu_ = Gpu::sharingWith(gpu);
        thread_ = std::make_unique<TaskThread>(1, [this] {
            renderer_.reset();
            gpu_->leave();
        });
        thread_->push([this] { gpu_->enter(); });
        thread_->drain();
    } catch (const DeviceError&) {
        thread_.reset();
    }
    run([&] { renderer_ = std::make_unique<Renderer>(thread_ ? *gpu_ : gpu, world_, settings_); });
    look(view, 0.0);
    home_ = camera();
}

void LiveDrawing::run(TaskThread::Task task)
{
    if (thread_) thread_->push(std::move(task));
    else task();
}

void LiveDrawing::look(const ParticleView& view, double time)
{
    if (thread_) thread_->drain();
    snapshot_.take(view);
    run([this, time] {
        renderer_->look(snapshot_.begin(), time);
        noteCamera();
        snapshot_.end();
    });
    if (thread_) thread_->drain();
}

void LiveDrawing::noteCamera()
{
    const LayerCamera camera = renderer_->camera();
    const FreeCamera free(camera, distanceOf(world_, camera), settings_.width, settings_.height);
    const std::lock_guard lock(mutex_);
    camera_ = free;
}

FreeCamera LiveDrawing::camera() const
{
    const std::lock_guard lock(mutex_);
    return camera_;
}

void LiveDrawing::draw(const ParticleView& view, double time, const std::optional<FreeCamera>& camera)
{
    if (thread_) thread_->waitForRoom();
    idle_ = false;
    snapshot_.take(view);
    run([this, time, camera] {
        seconds_ = secondsOf([&] {
            if (camera) renderer_->setCamera(camera->position(), camera->target());
            renderer_->draw(snapshot_.begin(), time);
            snapshot_.end();
            if (!camera) noteCamera();
            feed_.frame.put(jpegOf(renderer_->readImage(), JPEG_QUALITY));
        });
        idle_ = true;
        feed_.inbox.wake();
    });
}

}  // namespace knuckle
