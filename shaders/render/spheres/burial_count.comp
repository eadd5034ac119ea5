// One thread adds the space of one particle to its cell.
#include "render/spheres/burial.glsl"
#include "render/spheres/covered.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
uniform samplerBuffer positions;
layout(std430) buffer BurialCells { uint cells[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= frame.particleCount) return;
    vec4 position = texelFetch(positions, int(i));
#ifdef SURFACES
    // Things are seen through fluid.
    if (i >= frame.solidCount) return;
#endif
    if (isShown(i, position)) atomicAdd(cells[burialCell(position.xyz)], sphereSpace(i));
}
