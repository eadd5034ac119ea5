// A draft at the size of the frame.
uniform sampler2D smoothedPicture;
layout(location = 0) out vec4 enlarged;
#ifdef TRANSPARENT
uniform sampler2D smoothedCoverPicture;
#endif

void main()
{
    vec2 at = 0.5 * gl_FragCoord.xy / vec2(textureSize(smoothedPicture, 0));
    enlarged = vec4(textureLod(smoothedPicture, at, 0.0).rgb, 1.0);
#ifdef TRANSPARENT
    enlarged.a = textureLod(smoothedCoverPicture, at, 0.0).r;
#endif
}
