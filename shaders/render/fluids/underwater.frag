// What a camera in fluid sees: things through the fluid, and its upper surface from below, where rays leave it (Snell)
// or are thrown back (Fresnel).
#include "render/common/fluid_looks.glsl"
#include "render/common/rays/mirrored.glsl"
#include "render/common/sky.glsl"
#include "render/common/tone/tone_map.glsl"
#include "render/fluids/top_map.glsl"

uniform sampler2D topPicture;
uniform usamplerBuffer fluidMaterials;   // by fluid particle
layout(location = 0) out vec4 picture;

const float INDEX = 1.333;
const int STEPS = 48, HALVINGS_UP = 6;
// How far light is followed that the surface throws back, where nothing is seen to be met [m].
const float THROWN_BACK = 3.0;

vec3 topAt(vec3 world)
{
    return textureLod(topPicture, 0.5 * topPlace(world) + 0.5, 0.0).xyz;
}

bool isOutside(vec3 world)
{
    return any(greaterThan(abs(topPlace(world)), vec2(1.0))) || world.y > topAt(world).x;
}

/// Where a ray from the camera leaves the fluid [m]; `limit` if it does not before.
/// @param before  Gets a place just before that, where there is a surface above.
float wayInside(vec3 from, vec3 way, float limit, out float before)
{
    float far = limit;
    before = 0.0;
    for (int k = 1; k <= STEPS; ++k) {
        far = limit * float(k) / float(STEPS);
        if (isOutside(from + far * way)) break;
        before = far;
    }
    if (before >= limit) return limit;
    for (int k = 0; k < HALVINGS_UP; ++k) {
        float middle = 0.5 * (before + far);
        if (isOutside(from + middle * way)) far = middle;
        else before = middle;
    }
    return far;
}

/// Share of light that the surface throws back, from the cosine of its angle in the fluid (Fresnel, not polarized).
float thrownBack(float cosine)
{
    float sine2 = INDEX * INDEX * (1.0 - cosine * cosine);
    if (sine2 >= 1.0) return 1.0;
    float outside = sqrt(1.0 - sine2);
    vec2 r = vec2(INDEX * cosine - outside, INDEX * outside - cosine) /
             vec2(INDEX * cosine + outside, INDEX * outside + cosine);
    return 0.5 * dot(r, r);
}

void main()
{
    vec3 ray = viewRay(gl_FragCoord.xy), from = view.cameraPosition.xyz;
    float scene = texelFetch(depthPicture, ivec2(gl_FragCoord.xy), 0).r * frame.farDepth * length(ray);
    vec3 toward = normalize(ray), way = directionToWorld(toward);
    // Of several fluids the first one's look is taken.
    FluidLook look = fetchFluidLook(texelFetch(fluidMaterials, 0).x);
    vec3 sky = mix(frame.groundColor.rgb, frame.skyColor.rgb, 0.75);
    vec3 inside = look.color * (0.4 * max(frame.keyDirection.y, 0.0) * frame.keyColor.rgb + 0.6 * sky);
    float before, limit = min(scene, 3.5 * topHalfSide()), far = wayInside(from, way, limit, before);
    vec3 light = lightIn(texelFetch(litPicture, ivec2(gl_FragCoord.xy), 0).rgb) / frame.groundColor.w;
    if (far < limit) {
        vec3 top = topAt(from + before * way), p = far * toward;
        // At a side it is below the surface just before, of which only texels with fluid know.
        vec4 heights = textureGather(topPicture, 0.5 * topPlace(from + before * way) + 0.5);
        float height = max(max(heights.x, heights.y), max(heights.z, heights.w));
        bool isTop = from.y + far * way.y > height - 0.1 * frame.fluidRadius;
        vec3 n = directionToView(isTop ? normalize(vec3(-top.y, 1.0, -top.z)) : way);
        float cosine = max(dot(n, toward), 0.0), share = isTop ? thrownBack(cosine) : 0.0;
        vec3 down = reflect(toward, n), up = refract(toward, -n, INDEX);
        vec3 beyond = share < 1.0 && isTop ? lightAlong(p + 0.01 * up, up, skyTowards(up)) : light;
        vec3 back = exp(-THROWN_BACK * (look.absorption + look.scattering)) * frame.groundColor.rgb +
                    inside * (1.0 - exp(-THROWN_BACK * look.scattering));
        if (share > 0.02) back = lightAlong(p + 0.01 * down, down, back);
        light = mix(beyond, back, share);
    }
    light = light * exp(-far * (look.absorption + look.scattering)) + inside * (1.0 - exp(-far * look.scattering));
    float dimming = look.scattering + dot(look.absorption, vec3(1.0 / 3.0));
    light += look.emission * look.color * (1.0 - exp(-far * dimming));
    vec3 color = written(light * frame.groundColor.w);
    picture = vec4(color, lightness(color));
}
