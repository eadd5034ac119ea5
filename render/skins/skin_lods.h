#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/matter/skin.h"

namespace knuckle {

/// A skin's triangles at one level of detail.
struct SkinLod {
    float error = 0.0f;  ///< How far its surface is from the mesh's, except for a few percent of the vertices [m].
    uint32_t firstIndex = 0, indexCount = 0;  ///< In SkinLods::indices.
    uint32_t vertexCount = 0;                 ///< It uses this many of SkinLods::vertices, from the first on.
};

/// A skin's mesh and coarser ones over the same vertices, from fine to coarse, each with clearly fewer triangles than
/// the one before.
struct SkinLods {
    std::vector<uint32_t> vertices;  ///< Indices into SkinMesh::vertices; those of coarse levels come first.
    std::vector<uint32_t> indices;   ///< Into `vertices`, three a triangle.
    std::vector<SkinLod> levels;     ///< The first is the mesh itself.
};

/// Simplifies by quadric error metrics (Garland and Heckbert 1997), as implemented in meshoptimizer, so that joints can
/// bend. Vertices that coincide, because colour, texture or normal have a border there, continue to do so.
SkinLods makeSkinLods(const SkinMesh& mesh);

}  // namespace knuckle
