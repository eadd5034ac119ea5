#pragma once

#include "shared/draw_types.h"
#include "sim/gpu/buffer_table.h"
#include "sim/gpu/gpu.h"
#include "sim/world/world.h"

namespace knuckle {

/// What the device knows of the drawn skins of a world. Wearers of those without a two-sided material come first.
struct SkinBuffers {
    SkinBuffers() = default;
    /// @throws InputError for skins that are too large for the device.
    SkinBuffers(const Gpu& gpu, const World& world);
    void addTo(BufferTable& table);

    uint32_t wearerCount = 0, oneSidedCount = 0;
    uint32_t groupCount = 0;  ///< Of SKIN_GROUP_SIZE vertices, of all wearers.
    Buffer<uint32_t> indices;
    Buffer<gpu::SkinVertex> vertices;
    Buffer<gpu::vec4> vertexLooks;  ///< Per vertex: uv, colour as a number, material.
    Buffer<gpu::SkinLod> lods;
    Buffer<gpu::SkinWearer> wearers;
    Buffer<gpu::uvec4> groups;    ///< Wearer, first vertex, how many of the wearer's vertices come before.
    Buffer<gpu::vec4> centres;    ///< Per body: its mass centre at rest; w: how far its skin reaches, -1: it has none.
    Buffer<gpu::vec4> materials;  ///< As in SkinLooks.
    Buffer<gpu::uvec4> levels;
    Buffer<uint32_t> texels;
    Buffer<gpu::DrawElementsArguments> draws;  ///< Per wearer: the camera's, then the light's.
    Buffer<uint32_t> placeCounts;              ///< Per wearer: how many of its vertices are posed.
    Buffer<gpu::uvec4> places;                 ///< Per vertex of each wearer: place and normal.
};

}  // namespace knuckle
