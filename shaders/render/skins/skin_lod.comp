// One thread a wearer chooses its levels of detail for the camera and the key light: the coarsest whose error is at
// most a part of a pixel, or of a texel. The camera does not draw a wearer out of its sight.
#include "render/common/frame_blocks.glsl"
#include "shared/draw_types.h"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) readonly buffer SkinWearers { SkinWearer wearers[]; };
layout(std430) readonly buffer SkinLods { SkinLod lods[]; };
layout(std430) writeonly buffer SkinDraws { DrawElementsArguments draws[]; };   // the camera's, then the light's
layout(std430) writeonly buffer SkinPlaceCounts { uint placeCounts[]; };
uniform samplerBuffer skinCentres;          // per body, its mass centre at rest; w: reach of its skin
uniform samplerBuffer bodyCentres;

// The depth of the nearest part of a wearer [m]; below 0: all of it is beyond one side of the picture.
float nearestInSight(SkinWearer wearer)
{
    vec2 slope = frame.tanHalfFov * vec2(float(frame.width) / float(frame.height), 1.0);
    vec2 length = sqrt(1.0 + slope * slope), right = slope * (1.0 - pictureShift());
    vec2 left = slope * (1.0 + pictureShift());
    float nearest = 1e30;
    bvec4 beyond = bvec4(true);
    bool behind = true;
    for (uint i = 0u; i < wearer.bodyCount; ++i) {
        int body = int(wearer.firstBody + i);
        float reach = texelFetch(skinCentres, body).w;
        if (reach < 0.0) continue;
        vec3 p = toView(texelFetch(bodyCentres, body).xyz);
        nearest = min(nearest, -p.z - reach);
        behind = behind && p.z > reach;
        vec4 outside = vec4(vec2(p.xy + p.z * right), vec2(-p.xy + p.z * left)) - reach * length.xyxy;
        beyond = bvec4(uvec4(beyond) & uvec4(greaterThan(outside, vec4(0.0))));
    }
    return behind || any(beyond) ? -1.0 : max(nearest, 0.0);
}

uint coarsestWithin(SkinWearer wearer, float error)
{
    uint chosen = 0u;
    while (chosen + 1u < wearer.lodCount && lods[wearer.firstLod + chosen + 1u].error <= error) ++chosen;
    return wearer.firstLod + chosen;
}

DrawElementsArguments drawOf(SkinWearer wearer, SkinLod lod)
{
    return DrawElementsArguments(lod.indexCount, 1u, lod.firstIndex, wearer.firstPlace, 0u);
}

void main()
{
    uint index = gl_GlobalInvocationID.x, count = uint(wearers.length());
    if (index >= count) return;
    SkinWearer wearer = wearers[index];
    float depth = nearestInSight(wearer);
    float pixel = 2.0 * frame.tanHalfFov * max(depth, 0.0) * float(frame.resolveFactor) / float(frame.height);
    float texel = 2.0 * view.lightCentre.w / frame.shadowSize;
    SkinLod seen = lods[coarsestWithin(wearer, frame.keyColor.w * pixel)];
    SkinLod shading = lods[coarsestWithin(wearer, SKIN_TEXELS_A_PIXEL * frame.keyColor.w * texel)];
    if (depth < 0.0) seen.indexCount = seen.vertexCount = 0u;
    draws[index] = drawOf(wearer, seen);
    draws[count + index] = drawOf(wearer, shading);
    placeCounts[index] = max(seen.vertexCount, shading.vertexCount);
}
