// One thread a particle that bodies share: puts it at the mean of their goals (section 4), or where a body that does
// not move has it.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/shared_goals.glsl"
#include "sim/common/particles.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedParticles;
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.sharedCount) return;
    uint i = texelFetch(sharedParticles, int(k)).x;
    if (!moves(fetchRank(i).mover)) return;   // a body that is held is the first of its bodies
    PointState goal = meanGoal(i);
    positions[i].xyz = goal.position;
    velocities[i] = vec4(goal.velocity, 0);
}
