// One thread a particle: takes over the position that stabilization moved. The predicted move starts there now, so the
// prediction has moved with it (Macklin et al. 2014, 4.4: moving both adds no velocity).
#include "shared/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer stabilized;
BUFFER(vec4, Positions, positions);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    positions[i].xyz = texelFetch(stabilized, int(i)).xyz;
}
