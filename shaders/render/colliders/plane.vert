// One triangle over the whole picture, with what all pixels of a plane share.
#include "render/common/frame_blocks.glsl"
#include "render/common/screen.glsl"
#include "render/common/surface.glsl"

uniform samplerBuffer colliderPlanes;       // two a plane: unit normal, its component of the plane's points; colour

flat out vec4 planeInView;                  // normal; w: the eye's height above the plane
flat out uint normalWord;
flat out vec4 planeColor;                   // rgb; w: 1 for the ground

void main()
{
    vec4 plane = texelFetch(colliderPlanes, 2 * gl_InstanceID);
    vec3 normal = directionToView(plane.xyz);
    planeInView = vec4(normal, dot(view.cameraPosition.xyz, plane.xyz) - plane.w);
    normalWord = packNormal(normal);
    planeColor = texelFetch(colliderPlanes, 2 * gl_InstanceID + 1);
    gl_Position = screenCorner();
}
