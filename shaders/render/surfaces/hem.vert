// Half a tube along an edge of a sheet, from its one layer to its other.
#include "render/common/thing_out.glsl"
#include "render/surfaces/surface_color.glsl"
#include "shared/matter_types.h"

uniform usamplerBuffer hemEdges;            // four vertices in a row; the middle ones are the edge
uniform samplerBuffer surfacePlaces;
uniform samplerBuffer surfaceNormals;       // w: half the thickness [m]
uniform samplerBuffer surfaceLooks;

out vec3 viewNormal;
out vec3 viewPlace;
out vec3 colorRoots;
out vec3 weave;

vec3 placeOf(uint vertex)
{
    return texelFetch(surfacePlaces, int(vertex)).xyz;
}
#ifdef LAYERS
uniform samplerBuffer earlierSurfacePlaces;
#endif

void main()
{
    uvec4 row = texelFetch(hemEdges, gl_InstanceID);
    bool last = (gl_VertexID & 1) != 0;
    int vertex = int(last ? row.z : row.y);
    vec3 along = last ? placeOf(row.w) - placeOf(row.y) : placeOf(row.z) - placeOf(row.x);
    vec4 normal = texelFetch(surfaceNormals, vertex);
    vec3 outward = cross(along, normal.xyz);
    outward /= max(length(outward), 1e-12);
    float angle = 3.14159265 * (float(gl_VertexID / 2) / float(HEM_STRIP / 2 - 1) - 0.5);
    vec3 away = sin(angle) * normal.xyz + cos(angle) * outward;
    viewPlace = toView(placeOf(uint(vertex)) + normal.w * away);
    viewNormal = directionToView(away);
    colorRoots = surfaceRoots(vertex, texelFetch(surfaceLooks, vertex).w);
    weave = vec3(0.0);
#ifdef LAYERS
    // An edge turns little from frame to frame: its roundness goes along.
    earlierPlace = texelFetch(earlierSurfacePlaces, vertex).xyz + normal.w * away;
    NAME_THING(texelFetch(surfaceParticles, vertex).x);
#endif
    gl_Position = projectView(viewPlace);
}
