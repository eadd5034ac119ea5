// One thread writes the corners of a triangle of cloth: of torn cells all the same one, so that none is drawn.
#include "shared/frame_types.h"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) writeonly buffer SurfaceIndices { uint indices[]; };
uniform usamplerBuffer clothTriangles;      // three vertices; w: cell
uniform usamplerBuffer clothTorn;

void main()
{
    uint triangle = gl_GlobalInvocationID.x;
    if (triangle >= uint(textureSize(clothTriangles))) return;
    uvec4 corners = texelFetch(clothTriangles, int(triangle));
    if (texelFetch(clothTorn, int(corners.w)).x != 0u) corners.yz = corners.xx;
    for (uint k = 0u; k < 3u; ++k) indices[3u * triangle + k] = corners[k];
}
