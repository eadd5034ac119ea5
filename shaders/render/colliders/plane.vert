// One triangle over the whole picture, with what all pixels of a plane share.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"

layout(location = 0) uniform vec4 plane;    // world: unit normal, and the normal's component of its points

flat out vec4 planeInView;                  // normal; w: the eye's height above the plane
flat out uint normalWord;

void main()
{
    vec3 normal = directionToView(plane.xyz);
    planeInView = vec4(normal, dot(view.cameraPosition.xyz, plane.xyz) - plane.w);
    normalWord = packNormal(normal);
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
