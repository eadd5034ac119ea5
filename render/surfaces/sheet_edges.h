#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/gpu_types.h"

namespace knuckle {

using Triangle = std::array<uint32_t, 3>;

/// Triangles around each vertex.
struct TriangleFans {
    std::vector<uint32_t> starts;     ///< Per vertex and behind the last one, into the next.
    std::vector<uint32_t> triangles;  ///< Indices.
};

TriangleFans makeFans(size_t vertexCount, std::span<const Triangle> triangles);

/// The edges of triangles that have a triangle on one side only, in its order: the vertex before the edge, its two
/// ends, and the vertex after it along the border.
std::vector<gpu::uvec4> borderEdges(std::span<const Triangle> triangles);

}  // namespace knuckle
