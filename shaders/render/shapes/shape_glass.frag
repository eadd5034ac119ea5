// A body's shape of glass, over the picture of all else.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/shapes/ray_rounded.glsl"

flat in vec4 rounded;
flat in vec4 source;
flat in mat3 toShape;

float hitFrom(vec3 origin, vec3 way, out vec3 normal)
{
    return rayRounded(origin, way, rounded.xyz, rounded.w, normal);
}

#include "render/common/rays/glass.glsl"

void main()
{
    vec3 normal, ray = viewRay(gl_FragCoord.xy), way = toShape * normalize(ray);
    float along = hitFrom(source.xyz, way, normal), depth = along / length(ray);
    if (along <= 0.0 || isHidden(depth)) discard;
    normal = normalize(normal);
    vec3 entry = source.xyz + along * way, least = rounded.xyz + rounded.w;
    Passage through = passGlass(entry, way, normal, 2.0 * length(least));
    float thick = through.inside / (2.0 * min(least.x, min(least.y, least.z)));
    through.exit = (through.exit - source.xyz) * toShape;
    through.way = through.way * toShape;
    picture = glassPicture(depth * ray, normal * toShape, through, unpackAlbedo(uint(source.w)), thick);
    gl_FragDepth = depth / frame.farDepth;
}
