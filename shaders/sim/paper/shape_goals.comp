// One thread a particle: its move to its goal Q r + c (eq. 8). joint_goals does this for shared particles. STABILIZE:
// it starts from there, and its predicted move with it (Macklin et al. 2014, 4.4: that adds no velocity).
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/particles.glsl"
#include "sim/paper/goals.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moved;
#ifdef STABILIZE
BUFFER(vec4, Positions, positions);
#else
BUFFER(vec4, Predicted, predicted);
#endif

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    Particle info = fetchParticle(i);
    if (info.bodyCount > 1u) return;
    bool matched = info.bodyCount == 1u && responds(info.body);
    vec3 goal = matched ? goalMove(info.body, fetchArm(i).r) : texelFetch(moved, int(i)).xyz;
#ifdef STABILIZE
    positions[i].xyz += goal;
#else
    predicted[i].xyz = goal;
#endif
}
