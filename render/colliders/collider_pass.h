#pragma once

#include "render/colliders/mesh_pass.h"
#include "render/picture/sided_pass.h"
#include "render/settings.h"
#include "render/view/camera.h"
#include "shared/frame_types.h"

namespace knuckle {

/// Draws the visible colliders: planes over the whole picture, grids as triangles, others as shapes ray-cast inside
/// boxes.
class ColliderPass {
public:
    /// @param table must have "frame", "view", "colliderPlaces", "finishes" and what PictureLooks adds.
    ColliderPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
                 const SceneExtent& extent, const RenderTargets& targets);
    ColliderPass(const ColliderPass&) = delete;
    ColliderPass& operator=(const ColliderPass&) = delete;

    /// Into the shadow map. Planes cast no shadow.
    void drawShadow(KernelTimer& timer) const;
    /// Into the geometry buffers.
    void draw(KernelTimer& timer) const;
    bool hasGlass() const { return glassCount_ > 0; }
    /// Over the lit picture, into the target for glass.
    void drawGlass(KernelTimer& timer, FluidSide side) const { drawShapes(timer, glass_.of(side), glassCount_); }

private:
    void upload(const World& world, const SceneExtent& extent, bool seesThrough);
    static void drawShapes(KernelTimer& timer, const DrawPass& pass, uint32_t count);

    MeshPass meshes_;
    Buffer<gpu::vec4> planes_;  ///< Two each: colour, w: whether it is the ground; its collider, FLOOR_*, finish.
    Buffer<gpu::vec4> shapes_;  ///< A ColliderInstance each; those of glass last.
    uint32_t opaqueCount_ = 0, glassCount_ = 0;
    DrawPass planePass_, shapePass_, shapeShadow_, glassShadow_;
    SidedPass glass_;
};

}  // namespace knuckle
