#pragma once

#include "render/draw_pass.h"
#include "render/layers/earlier_buffers.h"
#include "render/picture/render_targets.h"
#include "render/settings.h"
#include "render/surfaces/surface_arrays.h"
#include "shared/draw_types.h"
#include "sim/gpu/buffer_table.h"
#include "sim/gpu/kernel.h"

namespace knuckle {

/// Draws cloth and soft bodies as smooth surfaces (World::drawn): where their particles take them, on the device.
class SurfacePass {
public:
    /// @param table must have "frame", "view", "positions", "velocities" and "distanceStates".
    SurfacePass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
                const RenderTargets& targets);
    SurfacePass(const SurfacePass&) = delete;
    SurfacePass& operator=(const SurfacePass&) = delete;

    /// Places the vertices of a frame.
    void update(KernelTimer& timer);
    /// Into the shadow map.
    void drawShadow(KernelTimer& timer) const;
    /// Into the geometry buffers.
    void draw(KernelTimer& timer) const;
    /// Remembers where vertices are, for the layers of the next frame.
    void endFrame() { earlier_.take(); }

private:
    void upload(BufferTable& table, const SurfaceArrays& arrays);

    uint32_t clothVertexCount_ = 0, softVertexCount_ = 0, clothTriangleCount_ = 0, cellCount_ = 0;
    bool tears_ = false;  ///< Whether cloth of it may tear.
    Buffer<uint32_t> indices_, fanStarts_, fans_, particles_, nodes_, torn_;
    Buffer<gpu::vec4> looks_, places_, normals_;
    Buffer<gpu::ClothSheet> sheets_;
    Buffer<gpu::uvec4> clothVertices_, clothCells_, clothTriangles_, hemEdges_;
    Buffer<gpu::uvec2> softVertices_, softLinks_;
    Buffer<gpu::DrawElementsArguments> draws_;
    EarlierBuffers earlier_;
    Kernel clothCellsKernel_, clothTrianglesKernel_, clothPlacesKernel_, softPlacesKernel_, normalsKernel_;
    DrawPass surfaces_, hems_, shadow_;
};

}  // namespace knuckle
