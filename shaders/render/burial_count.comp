// One thread adds one particle to its cell.
#include "shared/burial.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(binding = POSITIONS_UNIT) uniform samplerBuffer positions;
layout(std430, binding = RENDER_CELLS_SLOT) buffer Cells { uint cells[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= frame.particleCount) return;
    atomicAdd(cells[burialCell(texelFetch(positions, int(i)).xyz)], 1u);
}
