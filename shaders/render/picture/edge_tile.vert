// One point per tile of EDGE_TILE x EDGE_TILE pixels, dropped if the tile shows only ground and sky: these have no
// steps, since their pattern is filtered already and their shadows are soft.
#include "render/common/frame.glsl"
#include "render/picture/shade.glsl"

uniform usampler2D shadePicture;

#ifdef FLUIDS
uniform sampler2D fluidDepthPicture;
#endif

#ifdef GLASS
uniform sampler2D glassDepthPicture;
#endif

const int HALF_TILE = EDGE_TILE / 2;

void main()
{
    ivec2 tiles = (ivec2(frame.width, frame.height) + EDGE_TILE - 1) / EDGE_TILE;
    ivec2 tile = ivec2(gl_VertexID % tiles.x, gl_VertexID / tiles.x);
    vec2 texel = 1.0 / vec2(textureSize(shadePicture, 0));
    uvec4 things = uvec4(0u);
    // Half-resolution pixels of the tile and one more all around, four at a time.
    for (int y = 0; y <= HALF_TILE; y += 2)
        for (int x = 0; x <= HALF_TILE; x += 2)
        {
            vec2 place = vec2(tile * HALF_TILE + ivec2(x, y)) * texel;
            things |= shadeThing(textureGather(shadePicture, place));
#ifdef FLUIDS
            things |= uvec4(lessThan(textureGather(fluidDepthPicture, place), vec4(1.0)));
#endif
#ifdef GLASS
            things |= uvec4(lessThan(textureGather(glassDepthPicture, place), vec4(1.0)));
#endif
        }
    bool empty = things == uvec4(0u);
    vec2 centre = (vec2(tile) + 0.5) * float(EDGE_TILE) / vec2(frame.width, frame.height);
    gl_Position = vec4(empty ? vec2(-2.0) : 2.0 * centre - 1.0, 0.0, 1.0);
    gl_PointSize = float(EDGE_TILE);
}
