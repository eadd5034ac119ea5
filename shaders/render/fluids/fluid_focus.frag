// How the surface of fluid, as the key light sees it, gathers light: its curvature, by derivatives along rows and,
// COLUMNS, along columns of what came of that.
#include "render/fluids/gaussian.glsl"

#ifdef COLUMNS
uniform sampler2D fluidBendPicture;
layout(location = 0) out vec2 focus;      // trace [1/m] and determinant [1/m^2] of the second derivatives of the depth
#else
uniform sampler2D fluidShadowPicture;
layout(location = 0) out vec3 bend;       // depth [m], below 0 for none, and its first and second derivatives
#endif

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(
#ifdef COLUMNS
        fluidBendPicture, 0) - 1;
    vec3 middle = texelFetch(fluidBendPicture, here, 0).rgb;
    bool any = middle.x >= 0.0;
#else
        fluidShadowPicture, 0) - 1;
    float metres = 2.0 * view.lightDepth.x, middle = texelFetch(fluidShadowPicture, here, 0).r;
    bool any = middle < 1.0;
    middle *= metres;
#endif
    float texel = 2.0 * view.lightCentre.w / float(last.x + 1), width = gaussianWidth(texel), weight = 0.0;
    int reach = any ? gaussianReach(texel) : 0;
    vec3 sum = vec3(0.0);
    for (int k = -reach; k <= reach; ++k) {
        vec3 weights = weightsAt(float(k) * texel, width);
        weight += weights.x;
#ifdef COLUMNS
        vec3 there = texelFetch(fluidBendPicture, clamp(here + ivec2(0, k), ivec2(0), last), 0).rgb;
        if (there.x < 0.0) there = middle;
        sum += weights * vec3(there.z, there.y, stepOf(there.x, middle.x));
    }
    sum /= weight;
    focus = any ? vec2(sum.x + sum.z, sum.x * sum.z - sum.y * sum.y) : vec2(0.0);
#else
        float there = metres * texelFetch(fluidShadowPicture, clamp(here + ivec2(k, 0), ivec2(0), last), 0).r;
        sum += weights * stepOf(there, middle);
    }
    bend = any ? sum / weight + vec3(middle, 0.0, 0.0) : vec3(-1.0, 0.0, 0.0);
#endif
}
