// The map of the fluid's upper surface, seen from straight above: a square over the bounds of all particles.
#include "render/common/frame_blocks.glsl"

const float NO_FLUID = -1e4;   // in place of a height [m]

/// Half a side [m].
float topHalfSide()
{
    vec3 extent = view.particleHigh.xyz - view.particleLow.xyz;
    return 0.5 * max(extent.x, extent.z) + 2.0 * frame.fluidRadius;
}

/// The place of a point in it, each -1 ... 1.
vec2 topPlace(vec3 world)
{
    return (world.xz - 0.5 * (view.particleLow.xz + view.particleHigh.xz)) / topHalfSide();
}

/// What the map holds of a height [m], 0 ... 1 from high to low.
float topDepth(float height)
{
    float high = view.particleHigh.y + frame.fluidRadius, low = view.particleLow.y - frame.fluidRadius;
    return (high - height) / (high - low);
}

/// And back.
float topHeight(float depth)
{
    float high = view.particleHigh.y + frame.fluidRadius, low = view.particleLow.y - frame.fluidRadius;
    return mix(high, low, depth);
}
