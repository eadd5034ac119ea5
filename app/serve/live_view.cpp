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
    : settings_(liveSettings(scene)), renderer_(gpu, scene.world, settings_)
{
    renderer_.look(view, 0.0);
    const LayerCamera camera = renderer_.camera();
    home_ = FreeCamera(camera, distanceOf(scene.world, camera), settings_.width, settings_.height);
    camera_ = home_;
}

std::string LiveView::draw(const ParticleView& view, double time)
{
    renderer_.setCamera(camera_.position(), camera_.target());
    renderer_.draw(view, time);
    return jpegOf(renderer_.readImage(), JPEG_QUALITY);
}

}  // namespace knuckle
