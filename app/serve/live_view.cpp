#include "app/serve/live_view.h"

#include <algorithm>

#include "render/view/camera.h"
#include "render/view/framed_sets.h"

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

LiveView::LiveView(Gpu& gpu, const Scene& scene, const ParticleView& view)
    : settings_(liveSettings(scene)), renderer_(gpu, scene.world, settings_), world_(scene.world),
      home_(freeCamera(view, 0.0)), camera_(home_)
{
}

FreeCamera LiveView::freeCamera(const ParticleView& view, double time)
{
    renderer_.look(view, time);
    const LayerCamera camera = renderer_.camera();
    return {camera, distanceOf(world_, camera), settings_.width, settings_.height};
}

const FreeCamera& LiveView::seenFrom(const ParticleView& view, double time)
{
    if (!isSteered_) camera_ = freeCamera(view, time);
    return camera_;
}

FreeCamera& LiveView::steered(const ParticleView& view, double time)
{
    seenFrom(view, time);
    isSteered_ = true;
    return camera_;
}

void LiveView::goHome()
{
    camera_ = home_;
    isSteered_ = true;
}

std::string LiveView::draw(const ParticleView& view, double time)
{
    if (isSteered_) renderer_.setCamera(camera_.position(), camera_.target());
    renderer_.draw(view, time);
    return jpegOf(renderer_.readImage(), JPEG_QUALITY);
}

}  // namespace knuckle
