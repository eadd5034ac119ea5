// A corner of a mesh or a heightfield that is a collider.
#include "render/common/frame_blocks.glsl"
#include "render/common/thing_out.glsl"
#include "render/colliders/collider_place.glsl"

uniform samplerBuffer meshCorners;          // two a corner, of the collider at rest: place, w: mesh; normal, w: finish
uniform samplerBuffer meshColors;           // w: the collider

out vec3 viewPlace;
out vec3 viewNormal;
flat out vec3 color;
flat out uint finishAlpha;
#ifdef PATTERNS
out vec3 ownPlace;
#endif

void main()
{
    vec4 corner = texelFetch(meshCorners, 2 * gl_VertexID), mesh = texelFetch(meshColors, int(corner.w));
    ColliderPlace at = fetchColliderPlace(mesh.w);
    NAME_THING(mesh.w);
    vec3 place = at.position + rotate(at.orientation, corner.xyz);
    viewPlace = toView(place);
    vec4 normal = texelFetch(meshCorners, 2 * gl_VertexID + 1);
    viewNormal = directionToView(rotate(at.orientation, normal.xyz));
    finishAlpha = uint(normal.w);
#ifdef PATTERNS
    ownPlace = corner.xyz;
#endif
    color = mesh.rgb;
#ifdef LIGHT_VIEW
    gl_Position = vec4(worldToLight(place), 1.0);
#else
    gl_Position = projectView(viewPlace);
#endif
}
