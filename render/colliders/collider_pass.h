#pragma once

#include "render/colliders/mesh_pass.h"
#include "render/view/camera.h"
#include "shared/frame_types.h"

namespace knuckle {

/// Draws the visible colliders: planes over the whole picture, grids as triangles, others as shapes ray-cast inside
/// boxes.
class ColliderPass {
public:
    /// @param table must have "frame", "view" and "colliderPlaces".
    ColliderPass(const Gpu& gpu, BufferTable& table, const World& world, const SceneExtent& extent,
                 const RenderTargets& targets);
    ColliderPass(const ColliderPass&) = delete;
    ColliderPass& operator=(const ColliderPass&) = delete;

    /// Into the shadow map. Planes cast no shadow.
    void drawShadow(KernelTimer& timer) const;
    /// Into the geometry buffers.
    void draw(KernelTimer& timer) const;

private:
    void upload(const World& world, const SceneExtent& extent);
    void drawShapes(KernelTimer& timer, const DrawPass& pass) const;

    MeshPass meshes_;
    Buffer<gpu::vec4> planes_;  ///< Two each: colour, w: whether it is the ground; its collider, FLOOR_*, finish.
    Buffer<gpu::vec4> shapes_;  ///< A ColliderInstance each.
    DrawPass planePass_, shapePass_, shapeShadow_;
};

}  // namespace knuckle
