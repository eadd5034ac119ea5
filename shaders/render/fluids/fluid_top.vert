// One point per fluid particle, seen from straight above. The surface is half a spacing above the middles of particles.
#include "render/common/drawn_radius.glsl"
#include "render/common/fluid_kind.glsl"
#include "render/fluids/top_map.glsl"

uniform samplerBuffer positions;

void main()
{
    uint i = frame.solidCount + gl_VertexID;
    vec4 position = texelFetch(positions, int(i));
    float radius = drawnRadius(i);
    float top = position.y + 0.5 * frame.fluidRadius / SURFACE_RADIUS;
    gl_Position = vec4(topPlace(position.xyz), 2.0 * topDepth(top) - 1.0, 1.0);
    if (isLeftOut(i) || !isThere(position)) gl_Position = NOWHERE;
    gl_PointSize = radius / topHalfSide() * TOP_TEXELS;
}
