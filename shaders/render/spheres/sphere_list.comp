// One thread lists the particles of its run that are drawn, in order: points from the front of the list, quads after
// room for all particles, shadow casters after room for all once more. No atomics: the order of equal depths must not
// differ from run to run.
#include "render/common/frame_blocks.glsl"
#include "render/spheres/sphere_lists.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430, binding = RENDER_VISIBLE_SLOT) readonly buffer Visible { uint visible[]; };
layout(std430, binding = RENDER_COUNTS_SLOT) readonly buffer Counts { uvec4 counts[]; };
layout(std430, binding = RENDER_LIST_SLOT) writeonly buffer List { uint list[]; };

void main()
{
    uint begin = gl_GlobalInvocationID.x * LIST_CHUNK;
    uint end = min(begin + LIST_CHUNK, frame.particleCount);
    if (begin >= end) return;
    uvec3 next = counts[gl_GlobalInvocationID.x].xyz + uvec3(0u, 1u, 2u) * frame.particleCount;
    for (uint i = begin; i < end; ++i) {
        uint how = visible[i];
        if ((how & DRAWN_AS_POINT) != 0u) list[next.x] = i;
        if ((how & DRAWN_AS_QUAD) != 0u) list[next.y] = i;
        if ((how & CASTS_SHADOW) != 0u) list[next.z] = i;
        next += listCounts(how);
    }
}
