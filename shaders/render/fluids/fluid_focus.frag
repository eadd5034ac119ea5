// How the surface of fluid, as the key light sees it, gathers light: its curvature, by derivatives along rows and,
// COLUMNS, along columns of what came of that.
#include "render/fluids/gaussian.glsl"

#ifdef COLUMNS
uniform sampler2D fluidBendPicture;
const ivec2 STEP = ivec2(0, 1);
layout(location = 0) out vec2 focus;      // trace [1/m] and determinant [1/m^2] of the second derivatives of the depth
#else
uniform sampler2D fluidShadowPicture;
const ivec2 STEP = ivec2(1, 0);
layout(location = 0) out vec3 bend;       // depth [m], below 0 for none, and its first and second derivatives
#endif

// The depth there [m], and along columns its derivatives along rows. `any`: whether there is fluid.
vec3 bendAt(ivec2 at, out bool any)
{
#ifdef COLUMNS
    vec3 there = texelFetch(fluidBendPicture, at, 0).rgb;
    any = there.x >= 0.0;
    return there;
#else
    float there = texelFetch(fluidShadowPicture, at, 0).r;
    any = there < 1.0;
    return vec3(2.0 * view.lightDepth.x * there, 0.0, 0.0);
#endif
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = ivec2(SHADOW_TEXELS) - 1;
    bool any, isThere;
    vec3 middle = bendAt(here, any), sum = vec3(0.0);
    float texel = 2.0 * view.lightCentre.w / SHADOW_TEXELS, width = gaussianWidth(texel), weight = 0.0;
    int reach = any ? gaussianReach(texel) : 0;
    for (int k = -reach; k <= reach; ++k) {
        vec3 weights = weightsAt(float(k) * texel, width);
        vec3 there = bendAt(clamp(here + k * STEP, ivec2(0), last), isThere);
        float rise = stepOf(there.x, middle.x);
        weight += weights.x;
#ifdef COLUMNS
        sum += weights * (isThere ? vec3(there.zy, rise) : vec3(middle.zy, 0.0));
#else
        sum += weights * rise;
#endif
    }
    sum /= weight;
#ifdef COLUMNS
    focus = any ? vec2(sum.x + sum.z, sum.x * sum.z - sum.y * sum.y) : vec2(0.0);
#else
    bend = any ? sum + vec3(middle.x, 0.0, 0.0) : vec3(-1.0, 0.0, 0.0);
#endif
}
