#include "render/layers/layers.h"

namespace knuckle {

namespace {

void sharpen(CameraSettings& camera)
{
    camera.aperture = 0.0f;
    for (CameraKey& key : camera.keys) key.aperture = 0.0f;
}

}  // namespace

RenderSettings layerSettings(const RenderSettings& settings)
{
    RenderSettings layers = settings;
    layers.layers = true;
    layers.samples = 1;
    layers.antialiasing = 1;
    layers.quality = Quality::Good;
    layers.background = Background::Sky;
    layers.depth = 8;
    layers.shutter = layers.bloom = layers.vignette = 0.0f;
    layers.skinOpacity = 1.0f;
    layers.skinError = 0.0f;
    layers.markJoints = layers.legend = layers.highlightJoints = false;
    layers.overlay = {};
    if (showsQuantity(settings)) layers.colorBy = ColorBy::Particle;
    sharpen(layers.camera);
    for (Shot& shot : layers.shots) {
        shot.layout = PictureLayout::One;
        sharpen(shot.camera);
    }
    return layers;
}

}  // namespace knuckle
