// The mean of the samples of one pixel of the finished picture.
#include "render/common/frame.glsl"

uniform sampler2D smoothedPicture;
layout(location = 0) out vec4 resolved;
#ifdef TRANSPARENT
uniform sampler2D smoothedCoverPicture;
#endif

void main()
{
    int factor = int(frame.resolveFactor);
    vec3 sum = vec3(0.0);
    for (int y = 0; y < factor; ++y)
        for (int x = 0; x < factor; ++x)
            sum += texelFetch(smoothedPicture, ivec2(gl_FragCoord.xy) * factor + ivec2(x, y), 0).rgb;
    resolved = vec4(sum / float(factor * factor), 1.0);
#ifdef TRANSPARENT
    float covered = 0.0;
    for (int y = 0; y < factor; ++y)
        for (int x = 0; x < factor; ++x)
            covered += texelFetch(smoothedCoverPicture, ivec2(gl_FragCoord.xy) * factor + ivec2(x, y), 0).r;
    resolved.a = covered / float(factor * factor);
#endif
}
