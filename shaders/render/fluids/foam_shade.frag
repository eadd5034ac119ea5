// Foam, spray and bubbles over the lit picture: whiter the more of them there are.
#include "render/common/frame_blocks.glsl"
#include "render/common/tone/tone_map.glsl"

uniform sampler2D litPicture;
uniform sampler2D foamPicture;
layout(location = 0) out vec4 picture;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 foam = texelFetch(foamPicture, pixel, 0);
    if (foam.a <= 1e-3) discard;
    vec3 behind = lightIn(texelFetch(litPicture, pixel, 0).rgb) / frame.groundColor.w;
    vec3 color = written(mix(foam.rgb / foam.a, behind, exp(-foam.a)) * frame.groundColor.w);
    picture = vec4(color, lightness(color));
}
