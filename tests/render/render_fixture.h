#pragma once

#include <gtest/gtest.h>

#include "render/renderer.h"
#include "tests/render/still_world.h"

namespace knuckle::test {

/// One context for all pictures: making one takes longer than drawing.
inline Gpu& sharedGpu()
{
    static Gpu gpu;
    return gpu;
}

/// The picture of `world` at `time` [s]; fails the test on any GL error.
inline Image drawn(const World& world, const RenderSettings& settings, double time = 0.0,
                   const std::vector<uint32_t>& forms = {})
{
    Gpu& gpu = sharedGpu();
    const StillBuffers buffers(world, forms);
    Renderer renderer(gpu, world, settings);
    renderer.draw(buffers.view(), time);
    Image image = renderer.readImage();
    EXPECT_NO_THROW(gpu.checkErrors());
    return image;
}

/// Red, green and blue of a pixel; row 0 is the top one.
inline Eigen::Vector3i pixelAt(const Image& image, uint32_t x, uint32_t y)
{
    const uint8_t* p = image.rgb.data() + 3 * (size_t{y} * image.width + x);
    return {p[0], p[1], p[2]};
}

/// A camera at `position` that looks at `target`.
inline RenderSettings lookFrom(const Vector3f& position, const Vector3f& target, uint32_t width, uint32_t height)
{
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.camera.automatic = false;
    settings.camera.position = position;
    settings.camera.target = target;
    return settings;
}

}  // namespace knuckle::test
