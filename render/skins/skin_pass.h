#pragma once

#include <vector>

#include "render/draw_pass.h"
#include "render/picture/render_targets.h"
#include "sim/world/world.h"

namespace knuckle {

/// Draws the skins of objects, deformed on the device by where their bodies are.
class SkinPass {
public:
    /// @param table must have "frame", "view", "bodyCentres" and "bodyRotations".
    /// @throws InputError for skins that are too large for the device.
    SkinPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderTargets& targets);
    SkinPass(const SkinPass&) = delete;
    SkinPass& operator=(const SkinPass&) = delete;

    bool empty() const { return draws_.empty(); }
    /// Into the shadow map.
    void drawShadow(KernelTimer& timer) const { draw(timer, shadow_); }
    /// Into the geometry buffers.
    void draw(KernelTimer& timer) const { draw(timer, skins_); }

private:
    void upload(const Gpu& gpu, const World& world);
    void draw(KernelTimer& timer, const DrawPass& pass) const;

    std::vector<IndexedDraw> draws_;  ///< A skin each.
    Buffer<uint32_t> indices_;
    Buffer<gpu::vec4> vertices_;   ///< SKIN_VERTEX_TEXELS each.
    Buffer<uint32_t> wearers_;     ///< Per skin and object: its first body.
    Buffer<gpu::vec4> centres_;    ///< Per body: its mass centre at rest.
    Buffer<gpu::vec4> materials_;  ///< As in SkinLooks.
    Buffer<gpu::uvec4> levels_;
    Buffer<uint32_t> texels_;
    DrawPass skins_, shadow_;
};

}  // namespace knuckle
