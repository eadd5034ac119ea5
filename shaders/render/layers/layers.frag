// What a pixel shows, as numbers: normal in the world and view depth [m], below 0 where nothing is; albedo.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"

uniform usampler2D surfacePicture;
uniform sampler2D depthPicture;
layout(location = 0) out vec4 place;
layout(location = 1) out vec4 albedo;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthPicture, pixel, 0).r;
    uvec2 surface = texelFetch(surfacePicture, pixel, 0).rg;
    bool isThere = depth < 1.0;
    vec3 normal = isThere ? directionToWorld(unpackNormal(surface.x)) : vec3(0.0);
    place = vec4(normal, isThere ? depth * frame.farDepth : -1.0);
    albedo = isThere ? vec4(unpackAlbedo(surface.y), 1.0) : vec4(0.0);
}
