#pragma once

#include "shared/draw_types.h"
#include "sim/gpu/buffer_table.h"
#include "sim/gpu/gpu.h"
#include "sim/world/world.h"

namespace knuckle {

/// Device data of a world's drawn skins. Wearers of skins without a two-sided material come first.
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
    Buffer<gpu::uvec4> groups;    ///< Wearer, first vertex, number of the wearer's earlier vertices.
    Buffer<gpu::vec4> centres;    ///< Per body: its mass centre at rest; w: reach of its skin, -1 without skin.
    Buffer<gpu::vec4> materials;  ///< As in SkinLooks.
    Buffer<gpu::uvec4> levels;
    Buffer<uint32_t> texels;
    Buffer<gpu::DrawElementsArguments> draws;  ///< Per wearer: the camera's, then the light's.
    Buffer<uint32_t> placeCounts;              ///< Per wearer: number of its posed vertices.
    Buffer<gpu::uvec4> places;                 ///< Per vertex of each wearer: place and normal.
};

}  // namespace knuckle
