// A skin in the shadow map: its triangles give the depth, but for what its picture cuts out.
#include "render/skins/skin_looks.glsl"

in vec3 viewPlace;
in vec3 viewNormal;
in vec2 uv;
flat in vec3 vertexColor;
flat in int material;

void main()
{
    SkinLooks looks = fetchLooks(material);
    vec4 picture = skinPicture(looks, uv, dFdx(uv), dFdy(uv));
    if (picture.a < looks.alphaCutoff) discard;
}
