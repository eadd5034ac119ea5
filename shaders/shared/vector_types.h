// GLSL's vectors in C++, aligned as in std430 and std140.
#ifndef KNUCKLE_VECTOR_TYPES_H
#define KNUCKLE_VECTOR_TYPES_H

#ifdef __cplusplus
#include <cstdint>
namespace knuckle::gpu {
using uint = std::uint32_t;
struct alignas(16) vec4 { float x, y, z, w; };
struct alignas(16) uvec4 { uint x, y, z, w; };
struct alignas(8) uvec2 { uint x, y; };
}  // namespace knuckle::gpu
#endif
#endif
