// One thread a particle: the position for which fluids' neighbours are found: where it is in the middle of the step.
// Empties the lists of slots. SOLIDS: and unmarks what is near solids.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_state.glsl"
#include "sim/common/particles.glsl"
#include "sim/common/fluid_particles.glsl"
#include "shared/slot_lists.h"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer velocities;
BUFFER(vec4, FluidSearchPositions, fluidSearchPositions);
BUFFER(uvec4, SlotListSizes, slotListSizes);
#ifdef SOLIDS
BUFFER(uint, FluidNearSolids, fluidNearSolids);
#endif

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i < SLOT_LISTS) slotListSizes[i] = uvec4(0, 1, 1, 0);
#ifdef SOLIDS
    if (i < fluidNearSolids.length()) fluidNearSolids[i] = 0u;
#endif
    if (i >= sim.particleCount + sim.fluidCount) return;
    float time = sim.lookAhead * sim.substepTime;
    vec4 position = texelFetch(positions, int(i));
    vec3 x = position.xyz, v = texelFetch(velocities, int(i)).xyz;
    if (!isFluid(i)) {
        PointState state = pointState(fetchRank(i).mover, fetchArm(i).r);
        x = state.position;
        v = state.velocity;
    }
    fluidSearchPositions[i] = withPosition(position, x + time * v);
}
