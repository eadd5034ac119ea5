// Sizes of drawn particles, and which of them are active.
#include "render/common/frame_blocks.glsl"

float sphereRadius(uint particle)
{
    return particle < frame.solidCount ? frame.radius : frame.fluidRadius;
}

/// The space that a particle takes, of which a solid one takes SPACE_UNITS.
uint sphereSpace(uint particle)
{
    return particle < frame.solidCount ? SPACE_UNITS : frame.fluidSpace;
}

/// Whether a particle is active.
bool isThere(vec4 position)
{
    return position.w == 0.0;
}
