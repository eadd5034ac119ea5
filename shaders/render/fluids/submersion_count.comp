// One thread counts one fluid particle if it is near the camera.
#include "render/common/fluid_kind.glsl"
#include "render/common/sphere_sizes.glsl"

const float SUBMERSION_REACH = 1.5;   // [rest distances]

layout(local_size_x = RENDER_GROUP_SIZE) in;
uniform samplerBuffer positions;
layout(std430) buffer Submersion { uint counts[]; };

void main()
{
    uint i = frame.solidCount + gl_GlobalInvocationID.x;
    if (i >= frame.particleCount) return;
    vec4 position = texelFetch(positions, int(i));
    float reach = SUBMERSION_REACH * frame.fluidRadius / SURFACE_RADIUS;
    bool near = distance(position.xyz, view.cameraPosition.xyz) < reach;
    if (near && isThere(position) && !isLeftOut(i)) atomicAdd(counts[0], 1u);
}
