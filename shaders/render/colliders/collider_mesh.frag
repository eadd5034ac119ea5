// Depth, normal and colour of a mesh, which is visible from both sides.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/common/thing.glsl"
#ifdef PATTERNS
#include "render/common/finish_pattern.glsl"

in vec3 ownPlace;
#endif

in vec3 viewPlace;
in vec3 viewNormal;
flat in vec3 color;
flat in uint finishAlpha;
layout(location = 0) out uvec2 surface;

void main()
{
    vec3 normal = normalize(viewNormal);
    uint word = packAlbedo(color, 0.0) | finishAlpha << 24;
#ifdef PATTERNS
    word = patternedWord(word, ownPlace, 0u, pixelWidth(-viewPlace.z, normal));
#endif
    surface = uvec2(packNormal(dot(normal, viewPlace) > 0.0 ? -normal : normal), word);
    gl_FragDepth = -viewPlace.z / frame.farDepth;
    SHOW_THING(THING_COLLIDER);
}
