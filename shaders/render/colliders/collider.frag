// The pixel's ray against one obstacle: depth, normal and colour.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/common/thing.glsl"
#include "render/colliders/ray_shapes.glsl"
#ifdef PATTERNS
#include "render/common/finish_pattern.glsl"

flat in uint patternSeed;
#endif

flat in vec4 shapePosition;
flat in vec4 shapeOrientation;
flat in vec4 shapeHalfExtents;
flat in vec4 shapeColor;
flat in uint finishAlpha;
in vec3 boxPoint;
layout(location = 0) out uvec2 surface;

void main()
{
    vec3 ray = directionToWorld(viewRay(gl_FragCoord.xy));
    vec3 origin = rotateBack(shapeOrientation, view.cameraPosition.xyz - shapePosition.xyz);
    vec3 normal;
    vec3 way = rotateBack(shapeOrientation, ray);
    float depth = rayShape(uint(shapeColor.w), origin, way, shapeHalfExtents.xyz, shapePosition.w, normal);
    if (depth <= 0.0) discard;
    vec3 inView = directionToView(rotate(shapeOrientation, normal));
    uint word = packAlbedo(shapeColor.rgb, 0.0) | finishAlpha << 24;
#ifdef PATTERNS
    vec3 place = alongAxis(origin + depth * way, longestOf(shapeHalfExtents.xyz));
    word = patternedWord(word, place, patternSeed, pixelWidth(depth, inView));
#endif
    surface = uvec2(packNormal(inView), word);
    gl_FragDepth = depth / frame.farDepth;
    SHOW_THING(THING_COLLIDER);
}
