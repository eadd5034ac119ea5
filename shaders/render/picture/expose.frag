// Adds a draw's share to the light of the frame.
#include "render/common/frame.glsl"

uniform sampler2D SOURCE;
layout(location = 0) out vec4 exposed;   // light times what is covered, that

void main()
{
    exposed = texelFetch(SOURCE, ivec2(gl_FragCoord.xy), 0);
#ifndef TRANSPARENT
    exposed.a = 1.0;
#endif
    exposed *= frame.develop.x;
}
