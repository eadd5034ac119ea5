// One thread decides whether a cell of cloth is torn: whether one of the threads at its sides is.
#include "shared/frame_types.h"
#include "shared/matter_types.h"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) writeonly buffer ClothTorn { uint torn[]; };
uniform usamplerBuffer clothCells;          // four distances each
uniform samplerBuffer distanceStates;       // z: 1 if torn

void main()
{
    int cell = int(gl_GlobalInvocationID.x);
    if (cell >= textureSize(clothCells)) return;
    uvec4 sides = texelFetch(clothCells, cell);
    bool whole = true;
    for (int k = 0; k < 4; ++k)
        if (sides[k] != NEVER_TORN) whole = whole && texelFetch(distanceStates, int(sides[k])).z == 0.0;
    torn[cell] = whole ? 0u : 1u;
}
