// A mark in its colour, as displayed: without lighting.
#include "render/common/tone/tone_map.glsl"

flat in vec3 color;
layout(location = 0) out vec4 picture;

void main()
{
    // The filter of edges compares lightness.
    picture = vec4(writtenAs(color), dot(color, vec3(0.299, 0.587, 0.114)));
}
