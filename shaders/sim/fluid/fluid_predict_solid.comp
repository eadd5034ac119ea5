// One thread a solid particle: its position for fluids, which is where its mover is predicted to bring it in the
// substep. RELAX: its current position.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/pressure/slot_pressures.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
BUFFER(vec4, SlotPositions, newSlotPositions);
BUFFER(vec4, SlotLastPositions, newSlotLastPositions);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
#ifdef RELAX
    vec3 x = texelFetch(positions, int(i)).xyz, move = vec3(0);
#else
    MoverPoint point = moverPoint(fetchRank(i).mover, fetchArm(i).r);
    vec3 x = point.centre + point.arm + point.move, move = point.move;
#endif
    newSlotLastPositions[fetchParticleSlot(i)] = pack(SlotLast(x - move, false));
    newSlotPositions[fetchParticleSlot(i)] = pack(SlotPosition(x, 0.0));
}
