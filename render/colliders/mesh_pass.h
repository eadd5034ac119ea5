#pragma once

#include "render/draw_pass.h"
#include "render/picture/render_targets.h"
#include "shared/gpu_types.h"
#include "sim/world/world.h"

namespace knuckle {

/// Draws the visible colliders made of triangles: meshes and heightfields.
class MeshPass {
public:
    /// @param table must have "frame", "view" and "colliderPlaces".
    MeshPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderTargets& targets);
    MeshPass(const MeshPass&) = delete;
    MeshPass& operator=(const MeshPass&) = delete;

    /// Into the shadow map.
    void drawShadow(KernelTimer& timer) const { shadow_.draw(timer, GL_TRIANGLES, cornerCount()); }
    /// Into the geometry buffers.
    void draw(KernelTimer& timer) const { meshes_.draw(timer, GL_TRIANGLES, cornerCount()); }

private:
    uint32_t cornerCount() const { return static_cast<uint32_t>(corners_.size() / 2); }

    Buffer<gpu::vec4> corners_;  ///< Two a corner, in the collider's frame: place, w: mesh; normal, w: finish.
    Buffer<gpu::vec4> colors_;   ///< Of each mesh; w: its collider.
    DrawPass meshes_, shadow_;
};

}  // namespace knuckle
