// One thread a particle: puts it where its body has it (eq. 8), with its velocity.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_state.glsl"
#include "sim/common/particles.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    uint mover = fetchRank(i).mover;
    if (!moves(mover)) {
        velocities[i] = vec4(0);
        return;
    }
    PointState state = pointState(mover, fetchArm(i).r);
    positions[i] = vec4(state.position, 0);   // w: it is there, also if it was not before
    velocities[i] = vec4(state.velocity, 0);
}
