#include "render/layers/layer_passes.h"

#include <algorithm>

namespace knuckle {

namespace {

/// The texels of a picture, top row first.
template <typename T>
std::vector<T> read(const Texture& texture, GLenum format, GLenum type)
{
    const size_t width = texture.width(), height = texture.height();
    std::vector<T> texels(width * height);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glGetTexImage(GL_TEXTURE_2D, 0, format, type, texels.data());
    for (size_t row = 0; row < height / 2; ++row)
        std::swap_ranges(texels.begin() + static_cast<std::ptrdiff_t>(row * width),
                         texels.begin() + static_cast<std::ptrdiff_t>((row + 1) * width),
                         texels.end() - static_cast<std::ptrdiff_t>((row + 1) * width));
    return texels;
}

Eigen::Vector3d vectorOf(const gpu::vec4& v)
{
    return {v.x, v.y, v.z};
}

}  // namespace

LayerCamera layerCamera(const gpu::FrameView& view, float tanHalfFov, uint32_t height)
{
    LayerCamera camera{.focal = height / (2.0 * tanHalfFov)};
    camera.toWorld.matrix() << vectorOf(view.cameraRight), vectorOf(view.cameraUp), vectorOf(view.cameraBack),
        vectorOf(view.cameraPosition), 0, 0, 0, 1;
    return camera;
}

LayerPasses::LayerPasses(const Gpu& gpu, const BufferTable& table, const RenderTargets& targets)
    : targets_(targets),
      pass_(gpu, table, {"picture/screen", "layers/layers"}, {"surfacePicture", "depthPicture"}, targets.layers)
{
}

Layers LayerPasses::read(const gpu::FrameView& view, float tanHalfFov) const
{
    Layers layers;
    layers.width = targets_.layerPlaces.width();
    layers.height = targets_.layerPlaces.height();
    layers.places = knuckle::read<gpu::vec4>(targets_.layerPlaces, GL_RGBA, GL_FLOAT);
    layers.albedo = knuckle::read<gpu::vec4>(targets_.layerAlbedo, GL_RGBA, GL_FLOAT);
    layers.things = knuckle::read<gpu::uvec2>(targets_.things, GL_RG_INTEGER, GL_UNSIGNED_INT);
    layers.earlier = knuckle::read<gpu::vec4>(targets_.earlier, GL_RGBA, GL_FLOAT);
    layers.camera = layerCamera(view, tanHalfFov, layers.height);
    return layers;
}

}  // namespace knuckle
