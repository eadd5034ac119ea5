// What is where nothing is.
#include "render/common/sky.glsl"

// `ray`: in view space, of any length.
vec3 backdrop(vec3 ray)
{
#if defined(TRANSPARENT)
    return vec3(0.0);
#elif defined(BACKDROP_COLOR)
    return frame.backdrop.rgb;
#elif defined(SKY_PICTURE)
    return skyTowards(normalize(ray));
#else
    return skyRadiance(dot(normalize(ray), view.upInView.xyz));
#endif
}

// What far ground fades into.
vec3 backdropHaze(vec3 ray, vec3 lit)
{
#if defined(TRANSPARENT)
    return lit;
#elif defined(BACKDROP_COLOR)
    return frame.backdrop.rgb;
#else
    return hazeColor(ray);
#endif
}
