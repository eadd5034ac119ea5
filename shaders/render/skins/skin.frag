// Depth, normal and colour of a skin.
#include "render/common/frame_blocks.glsl"
#include "render/skins/skin_maps.glsl"
#include "render/common/thing.glsl"

in vec3 viewNormal;
in vec2 uv;
in vec3 colorRoots;
flat in int material;
#ifdef FINISHES
flat in uint finishAlpha;
#endif
layout(location = 0) out uvec2 surface;

void main()
{
    vec3 roots = colorRoots;
#ifdef MATERIALS
    SkinLooks looks = fetchLooks(material);
    vec4 picture = skinPicture(looks, uv, dFdx(uv), dFdy(uv));
    if (picture.a < looks.alphaCutoff || !(gl_FrontFacing || looks.twoSided)) discard;
    roots *= sqrt(picture.rgb);
#endif
    vec3 normal = viewNormal;
#ifdef NORMALS
    normal = mappedNormal(looks, material, normalize(normal), viewRay(gl_FragCoord.xy) / gl_FragCoord.w, uv);
#endif
#ifdef TWO_SIDED
    // A back is lit from its own side. A front's normal may point away a little where the mesh turns out of sight.
    if (!gl_FrontFacing && dot(normal, viewRay(gl_FragCoord.xy)) > 0.0) normal = -normal;
#endif
    uint word = packRoots(roots, 1.0);
#ifdef FINISHES
    uint finish = finishAlpha;
#ifdef ROUGHNESSES
    if (finish == ROUGHNESSES) finish += mappedFinish(looks, material, uv);
#endif
    word = (word & 0xffffffu) | finish << 24;
#endif
    surface = uvec2(packNormal(normal), word);
    gl_FragDepth = 1.0 / (gl_FragCoord.w * frame.farDepth);
    SHOW_THING(THING_BODY);
}
