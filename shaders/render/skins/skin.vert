// A vertex of a skin where the bodies of its wearer have it: linear blend skinning, sum w (c + R (v - c at rest)).
#include "render/common/frame_blocks.glsl"
#include "math/quaternion.glsl"

uniform samplerBuffer skinVertices;         // SKIN_VERTEX_TEXELS a vertex
uniform usamplerBuffer skinWearers;         // of each instance of a skin, the first body
uniform samplerBuffer skinCentres;          // of each body, its mass centre at rest
uniform samplerBuffer bodyCentres;
uniform samplerBuffer bodyRotations;

out vec3 viewPlace;
out vec3 viewNormal;
out vec2 uv;
flat out vec3 vertexColor;
flat out int material;

void main()
{
    int first = SKIN_VERTEX_TEXELS * gl_VertexID;
    vec4 rest = texelFetch(skinVertices, first), normal = texelFetch(skinVertices, first + 1);
    vec4 looks = texelFetch(skinVertices, first + 2), bodies = texelFetch(skinVertices, first + 3);
    vec4 weights = texelFetch(skinVertices, first + 4);
    int firstBody = int(texelFetch(skinWearers, int(normal.w) + gl_InstanceID).x);
    vec3 place = vec3(0.0), turned = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        int body = firstBody + int(bodies[i]);
        vec4 rotation = texelFetch(bodyRotations, body);
        vec3 arm = rest.xyz - texelFetch(skinCentres, body).xyz;
        place += weights[i] * (texelFetch(bodyCentres, body).xyz + rotate(rotation, arm));
        turned += weights[i] * rotate(rotation, normal.xyz);
    }
    viewPlace = toView(place);
    viewNormal = directionToView(turned);
    uv = looks.xy;
    vertexColor = unpackUnorm4x8(uint(looks.z)).rgb;
    material = int(rest.w);
#ifdef LIGHT_VIEW
    gl_Position = vec4(worldToLight(place), 1.0);
#else
    gl_Position = projectView(viewPlace);
#endif
}
