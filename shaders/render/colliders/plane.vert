// One triangle over the whole picture, with the values that all pixels of a plane share.
#include "render/common/frame_blocks.glsl"
#include "render/common/thing_out.glsl"
#include "render/colliders/collider_place.glsl"
#include "render/common/screen.glsl"
#include "render/common/surface.glsl"

uniform samplerBuffer colliderPlanes;       // two a plane: colour, w: 1 for the ground; its index, FLOOR_*, finish

flat out vec4 planeInView;                  // normal; w: the eye's height above the plane
flat out uint normalWord;
flat out vec4 planeColor;                   // rgb; w: 1 for the ground
flat out uvec2 planeLook;                   // FLOOR_*; finish
#ifdef FLOORS
flat out vec3 planeOrigin;
flat out vec4 planeTurn;
#endif

void main()
{
    vec4 plane = texelFetch(colliderPlanes, 2 * gl_InstanceID + 1);
    ColliderPlace place = fetchColliderPlace(plane.x);
    NAME_THING(plane.x);
    planeLook = uvec2(plane.yz);
#ifdef FLOORS
    planeOrigin = place.position;
    planeTurn = place.orientation;
#endif
    vec3 up = rotate(place.orientation, vec3(0, 1, 0)), normal = directionToView(up);
    planeInView = vec4(normal, dot(view.cameraPosition.xyz - place.position, up));
    normalWord = packNormal(normal);
    planeColor = texelFetch(colliderPlanes, 2 * gl_InstanceID);
    gl_Position = screenCorner();
}
