// One point per point of foam, at least as large as keeps it from flickering, and then the fainter: how white it makes
// what is behind it. Fluid before it dims it. What is behind things is left out.
#include "render/common/fog.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/fluid_kind.glsl"
#include "render/common/fluid_looks.glsl"
#include "render/common/submersion.glsl"

uniform samplerBuffer foamPlaces;        // xyz [m], w: opacity
uniform usamplerBuffer fluidMaterials;   // by fluid particle
uniform sampler2D depthPicture;
uniform sampler2D shadowPicture;
uniform sampler2D fluidWidePicture;
uniform sampler2D fluidGlowPicture;

flat out vec4 foam;   // rgb: its light times coverage; coverage in its middle

// Radius of the points, least and most [rest distances], and least radius as drawn [pixels].
const vec2 RADIUS = vec2(0.05, 0.16);
const float LEAST_PIXELS = 1.6;
// How far below the surface foam still lies on it, as the surface is smoothed [radii of fluid].
const float AFLOAT = 1.2;
const float ALBEDO = 0.9, KEY_SHARE = 0.4, AMBIENT_SHARE = 0.6;

/// How much of its light comes out of the fluid before it.
vec3 throughWater(float depth, ivec2 pixel)
{
    vec2 place = (vec2(pixel) + 0.5) / vec2(frame.width, frame.height);
    float below = depth - texelFetch(fluidWidePicture, pixel, 0).r - AFLOAT * frame.fluidRadius;
    // Of several fluids the first one's colour is taken.
    FluidLook look = fetchFluidLook(texelFetch(fluidMaterials, 0).x);
    float way = isUnderWater() ? depth : clamp(below, 0.0, textureLod(fluidGlowPicture, place, 0.0).a);
    return exp(-(look.absorption + look.scattering) * way);
}

vec3 lightAt(vec3 p)
{
    vec3 place = 0.5 * viewToLight(p) + 0.5;
    bool lit = min(place.z, 1.0) <= textureLod(shadowPicture, place.xy, 0.0).r + 1e-3;
    vec3 sky = mix(frame.groundColor.rgb, frame.skyColor.rgb, 0.75);
    return ALBEDO * ((lit ? KEY_SHARE : 0.0) * frame.keyColor.rgb + AMBIENT_SHARE * sky);
}

void main()
{
    vec4 place = texelFetch(foamPlaces, gl_VertexID);
    vec3 centre = toView(place.xyz);
    vec4 clip = projectView(centre);
    float depth = -centre.z;
    vec2 ndc = clip.xy / max(depth, 1e-6), size = vec2(frame.width, frame.height);
    ivec2 pixel = ivec2(clamp((0.5 * ndc + 0.5) * size, vec2(0.0), size - 1.0));
    bool seen = place.w > 0.0 && depth > frame.fluidRadius && all(lessThan(abs(ndc), vec2(1.02))) &&
                depth < texelFetch(depthPicture, pixel, 0).r * frame.farDepth;
    // Sizes that a point keeps.
    float one = float(uint(gl_VertexID) * 2654435769u >> 16u) / 65535.0;
    float radius = mix(RADIUS.x, RADIUS.y, one * one) * frame.fluidRadius / SURFACE_RADIUS;
    float pixels = radius * float(frame.height) / (2.0 * frame.tanHalfFov * max(depth, 1e-6));
    float drawn = max(pixels, LEAST_PIXELS), part = pixels / drawn;
    // The profile of foam.frag has a third of a disc's area.
    vec3 through = throughWater(depth, pixel);
    float coverage = 3.0 * part * part * place.w;
    vec3 light = lightAt(centre) * through;
#ifdef FOG
    light = mix(frame.fog.rgb, light, clearShare(centre, length(centre)));
#endif
    foam = vec4(light, 1.0) * coverage * dot(through, vec3(1.0 / 3.0));
    gl_PointSize = 2.0 * drawn;
    gl_Position = seen ? vec4(ndc, 0.0, 1.0) : NOWHERE;
}
