// A vertex of cloth or of a soft body. Cloth has two layers and, for the light, one between them.
#include "render/common/thing_out.glsl"
#include "render/surfaces/surface_color.glsl"
#include "shared/matter_types.h"

uniform samplerBuffer surfacePlaces;
uniform samplerBuffer surfaceNormals;       // w: half the thickness [m]
uniform samplerBuffer surfaceLooks;         // threads of the weave across and along; z: half; w: colour

out vec3 viewNormal;
out vec3 viewPlace;
out vec3 colorRoots;
out vec3 weave;                             // threads; z: 0 without
#ifdef LAYERS
uniform samplerBuffer earlierSurfacePlaces;
uniform samplerBuffer earlierSurfaceNormals;
#endif

void main()
{
    int count = textureSize(surfaceLooks), vertex = gl_VertexID % count, layer = gl_VertexID / count;
    float side = float(layer == 0) - float(layer == 1);
    vec4 normal = texelFetch(surfaceNormals, vertex), looks = texelFetch(surfaceLooks, vertex);
    vec3 place = texelFetch(surfacePlaces, vertex).xyz + side * normal.w * normal.xyz;
    viewPlace = toView(place);
    viewNormal = directionToView(side * normal.xyz);
    colorRoots = surfaceRoots(vertex, looks.w);
    weave = vec3(looks.xy, looks.x >= 0.0 ? 1.0 : 0.0);
#ifdef LAYERS
    earlierPlace = texelFetch(earlierSurfacePlaces, vertex).xyz +
                   side * normal.w * texelFetch(earlierSurfaceNormals, vertex).xyz;
    NAME_THING(texelFetch(surfaceParticles, vertex).x);
#endif
#ifdef LIGHT_VIEW
    gl_Position = vec4(worldToLight(place), 1.0);
#else
    gl_Position = projectView(viewPlace);
#endif
}
