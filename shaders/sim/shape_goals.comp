// One thread a particle: its move to its goal Q r + c (eq. 8). Particles that bodies share are joint_goals' business.
#include "shared/kernel.glsl"
#include "shared/goals.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moved;
uniform samplerBuffer masses;
uniform samplerBuffer restOffsets;       // r of the first body, effective inverse mass in it
uniform usamplerBuffer particleInfo;
BUFFER(vec4, Predicted, predicted);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    uvec4 info = texelFetch(particleInfo, int(i));
    if (info.y > 1u) return;
    vec4 x = texelFetch(moved, int(i));
    float inverseMass = texelFetch(masses, int(i)).x;
    vec4 result = vec4(x.xyz, inverseMass * max(x.w, 1.0));
    if (inverseMass > 0.0 && info.y == 1u) {
        vec4 offset = texelFetch(restOffsets, int(i));
        result = vec4(goalMove(info.x, offset.xyz), offset.w * max(splits(info.x), 1.0));
    }
    predicted[i] = result;
}
