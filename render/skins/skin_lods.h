#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/matter/skin.h"

namespace knuckle {

/// A skin's triangles at one level of detail.
struct SkinLod {
    float error = 0.0f;  ///< How far its surface is off the mesh's, but for some vertices in a hundred [m].
    uint32_t firstIndex = 0, indexCount = 0;  ///< In SkinLods::indices.
    uint32_t vertexCount = 0;                 ///< It uses the first so many of SkinLods::vertices.
};

/// A skin's mesh and coarser ones over the same vertices, from fine to coarse, each with a good part fewer triangles
/// than the one before.
struct SkinLods {
    std::vector<uint32_t> vertices;  ///< Indices into SkinMesh::vertices: those of coarse levels come first.
    std::vector<uint32_t> indices;   ///< Into `vertices`, three a triangle.
    std::vector<SkinLod> levels;     ///< The first is the mesh itself.
};

/// Simplifies by quadric error metrics (Garland and Heckbert 1997), as meshoptimizer has them, so that joints can bend.
/// Where vertices lie on one another, since colour, texture or normal have a border there, they go on doing so.
SkinLods makeSkinLods(const SkinMesh& mesh);

}  // namespace knuckle
