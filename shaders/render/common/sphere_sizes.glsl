// How large particles are drawn, and which of them are there at all.
#include "render/common/frame_blocks.glsl"

float sphereRadius(uint particle)
{
    return particle < frame.solidCount ? frame.radius : frame.fluidRadius;
}

/// Of the space around, in units of which a solid particle takes SPACE_UNITS.
uint sphereSpace(uint particle)
{
    return particle < frame.solidCount ? SPACE_UNITS : frame.fluidSpace;
}

/// Whether a particle is active.
bool isThere(vec4 position)
{
    return position.w == 0.0;
}
