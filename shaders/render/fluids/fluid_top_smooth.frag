// The height of the upper surface and its slopes along x and z, along rows and, COLUMNS, along columns of that.
#include "render/fluids/gaussian.glsl"
#include "render/fluids/top_map.glsl"

#ifdef COLUMNS
uniform sampler2D topRowsPicture;
const ivec2 STEP = ivec2(0, 1);
#else
uniform sampler2D topDepthPicture;
const ivec2 STEP = ivec2(1, 0);
#endif
layout(location = 0) out vec3 surface;   // [m] or NO_FLUID, slopes

vec2 heightAt(ivec2 at)
{
#ifdef COLUMNS
    return texelFetch(topRowsPicture, at, 0).xy;
#else
    float depth = texelFetch(topDepthPicture, at, 0).r;
    return vec2(depth < 1.0 ? topHeight(depth) : NO_FLUID, 0.0);
#endif
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = ivec2(TOP_TEXELS) - 1;
    vec2 middle = heightAt(here);
    bool any = middle.x > NO_FLUID;
    float texel = 2.0 * topHalfSide() / TOP_TEXELS, width = gaussianWidth(texel), weight = 0.0;
    int reach = any ? gaussianReach(texel) : 0;
    vec3 sum = vec3(0.0);
    for (int k = -reach; k <= reach; ++k) {
        vec2 weights = weightsAt(float(k) * texel, width).xy, there = heightAt(clamp(here + k * STEP, ivec2(0), last));
        if (there.x <= NO_FLUID) there = middle;
        weight += weights.x;
        sum += vec3(weights, weights.x) * vec3(vec2(stepOf(there.x, middle.x)), there.y);
    }
    sum /= weight;
#ifdef COLUMNS
    sum = sum.xzy;   // the slope along columns is the second
#endif
    surface = any ? sum + vec3(middle.x, 0.0, 0.0) : vec3(NO_FLUID, 0.0, 0.0);
}
