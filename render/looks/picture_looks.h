#pragma once

#include "render/settings.h"
#include "render/sky/sky_textures.h"
#include "render/view/camera.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/buffer_table.h"
#include "sim/gpu/gpu.h"

namespace knuckle {

/// @throws InputError if a picture without a background has something that shows what is behind it, or marks.
void checkTransparency(const World& world, const RenderSettings& settings);

/// What passes read of finishes, lights and the sky.
class PictureLooks {
public:
    /// Adds "finishes", "lightSources", "skyPicture" and "skyBlurs" to the table. @throws InputError.
    PictureLooks(BufferTable& table, const World& world, const RenderSettings& settings, const SceneExtent& extent);
    PictureLooks(const PictureLooks&) = delete;
    PictureLooks& operator=(const PictureLooks&) = delete;

    /// What the lighting is compiled with.
    const Defines& lighting() const { return lighting_; }
    /// Whether the ground mirrors what stands on it.
    bool isMirror() const { return isMirror_; }

private:
    Buffer<gpu::vec4> finishes_, sources_;
    SkyTextures sky_;
    Defines lighting_;
    bool isMirror_;
};

}  // namespace knuckle
