// Depth, normal and colour of a skin.
#include "render/common/frame_blocks.glsl"
#include "render/skins/skin_looks.glsl"

in vec3 viewNormal;
in vec2 uv;
in vec3 vertexColor;
flat in int material;
layout(location = 0) out uvec2 surface;

void main()
{
    vec3 color = vertexColor;
#ifdef MATERIALS
    SkinLooks looks = fetchLooks(material);
    vec4 picture = skinPicture(looks, uv, dFdx(uv), dFdy(uv));
    if (picture.a < looks.alphaCutoff || !(gl_FrontFacing || looks.twoSided)) discard;
    color *= picture.rgb;
#endif
    vec3 normal = normalize(viewNormal);
    // A back is lit from its own side. A front's normal may point away a little where the mesh turns out of sight.
    bool away = !gl_FrontFacing && dot(normal, viewRay(gl_FragCoord.xy)) > 0.0;
    surface = uvec2(packNormal(away ? -normal : normal), packAlbedo(color, 1.0));
    gl_FragDepth = 1.0 / (gl_FragCoord.w * frame.farDepth);
}
