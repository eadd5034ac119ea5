// One thread a particle: its move to its goal Q r + c (eq. 8). Particles that bodies share are joint_goals' business.
// STABILIZE: it starts from there, and its predicted move with it (Macklin et al. 2014, 4.4: that adds no velocity).
#include "sim/common/kernel.glsl"
#include "sim/paper/goals.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moved;
uniform samplerBuffer masses;
uniform samplerBuffer restOffsets;       // r of the first body
uniform usamplerBuffer particleInfo;
#ifdef STABILIZE
BUFFER(vec4, Positions, positions);
#else
BUFFER(vec4, Predicted, predicted);
#endif

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    uvec4 info = texelFetch(particleInfo, int(i));
    if (info.y > 1u) return;
    bool held = info.y == 1u && texelFetch(masses, int(i)).x > 0.0;
    vec3 goal = held ? goalMove(info.x, texelFetch(restOffsets, int(i)).xyz) : texelFetch(moved, int(i)).xyz;
#ifdef STABILIZE
    positions[i].xyz += goal;
#else
    predicted[i].xyz = goal;
#endif
}
