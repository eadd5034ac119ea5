#pragma once

#include "render/sky/sky_map.h"
#include "sim/gpu/buffer_table.h"
#include "sim/gpu/texture.h"

namespace knuckle {

/// A sky as shaders/render/common/sky_picture.glsl reads it. Without a map it is black and not read.
class SkyTextures {
public:
    explicit SkyTextures(const SkyMap* map);

    /// Adds "skyPicture" and "skyBlurs".
    void addTo(BufferTable& table) const { table.add(picture_, blurs_); }

private:
    Texture picture_, blurs_;
};

}  // namespace knuckle
