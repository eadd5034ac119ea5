// One thread turns the counts of all runs into where each run's list begins, and writes the draw arguments.
#include "render/common/frame_blocks.glsl"

layout(local_size_x = 1) in;
layout(std430, binding = RENDER_COUNTS_SLOT) buffer Counts { uvec4 counts[]; };
layout(std430, binding = RENDER_DRAWS_SLOT) writeonly buffer Draws { DrawArguments draws[DRAW_COUNT]; };

void main()
{
    uvec4 total = uvec4(0u);
    uint chunks = (frame.particleCount + LIST_CHUNK - 1u) / LIST_CHUNK;
    for (uint i = 0u; i < chunks; ++i) {
        uvec4 count = counts[i];
        counts[i] = total;
        total += count;
    }
    draws[POINT_DRAW] = DrawArguments(total.x, 1u, 0u, 0u, 0u, 0u, 0u, 0u);
    draws[QUAD_DRAW] = DrawArguments(4u, total.y, 0u, 0u, 0u, 0u, 0u, 0u);
    draws[SHADOW_DRAW] = DrawArguments(total.z, 1u, 2u * frame.particleCount, 0u, 0u, 0u, 0u, 0u);
}
