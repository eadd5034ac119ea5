// One thread writes the draw arguments of what is drawn only if the camera is in fluid: the points of the map from
// above, and a triangle over a whole target.
#include "render/common/frame.glsl"
#include "render/common/submersion.glsl"

layout(local_size_x = 1) in;
layout(std430) writeonly buffer UnderwaterDraws { DrawArguments draws[]; };

void main()
{
    uint once = isUnderWater() ? 1u : 0u;
    draws[0] = DrawArguments(once * (frame.particleCount - frame.solidCount), 1u, 0u, 0u);
    draws[1] = DrawArguments(once * 3u, 1u, 0u, 0u);
}
