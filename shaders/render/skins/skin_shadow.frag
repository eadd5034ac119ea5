// A skin in the shadow map: its triangles give the depth, except where its picture cuts them out.
#ifdef CUT_OUT
#include "render/skins/skin_looks.glsl"
#endif

in vec3 viewNormal;
in vec2 uv;
in vec3 colorRoots;
flat in int material;

void main()
{
#ifdef CUT_OUT
    SkinLooks looks = fetchLooks(material);
    if (skinPicture(looks, uv, dFdx(uv), dFdy(uv)).a < looks.alphaCutoff) discard;
#endif
}
