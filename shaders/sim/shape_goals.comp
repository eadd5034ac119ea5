// One thread a particle: its move to its goal Q r + c (eq. 8). Particles that bodies share are joint_goals' business.
#include "shared/kernel.glsl"
#include "shared/goals.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moved;
uniform samplerBuffer masses;
uniform samplerBuffer restOffsets;       // r of the first body
uniform usamplerBuffer particleInfo;
BUFFER(vec4, Predicted, predicted);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    uvec4 info = texelFetch(particleInfo, int(i));
    if (info.y > 1u) return;
    bool held = info.y == 1u && texelFetch(masses, int(i)).x > 0.0;
    vec3 goal = held ? goalMove(info.x, texelFetch(restOffsets, int(i)).xyz) : texelFetch(moved, int(i)).xyz;
    predicted[i] = vec4(goal, 0);
}
