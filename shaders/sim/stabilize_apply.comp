// One thread a particle: takes over both the positions and the predictions that stabilization moved (Macklin et al.
// 2014, 4.4: moving both adds no velocity).
#include "shared/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer stabilized;
uniform samplerBuffer moved;
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Predicted, predicted);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    positions[i].xyz = texelFetch(stabilized, int(i)).xyz;
    predicted[i].xyz = texelFetch(moved, int(i)).xyz;
}
