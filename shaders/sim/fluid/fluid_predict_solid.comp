// One thread a solid particle: its position for fluids, which is where its mover is predicted to bring it in the
// substep. RELAX: its current position.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/pressure/slot_pressures.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/fluid/walls/solid_cells.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
BUFFER(vec4, SlotPositions, newSlotPositions);
BUFFER(vec4, SlotMoves, newSlotMoves);
#ifndef RELAX
BUFFER(vec4, SlotSolidImpulses, newSlotSolidImpulses);
#endif

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    uint mover = fetchRank(i).mover;
#ifdef RELAX
    vec3 x = texelFetch(positions, int(i)).xyz, move = vec3(0);
    vec4 rotation = fetchRotation(mover);
#else
    MoverPoint point = moverPoint(mover, fetchArm(i).r);
    vec3 x = point.centre + point.arm + point.move, move = point.move;
    vec4 rotation = quaternionProduct(fetchRotationDelta(mover), fetchRotation(mover));
#endif
    vec2 turn = packTurn(rotation);
    newSlotMoves[fetchParticleSlot(i)] = vec4(move, -turn.y);
    newSlotPositions[fetchParticleSlot(i)] = vec4(x, turn.x);
#ifndef RELAX
    newSlotSolidImpulses[fetchParticleSlot(i)] = vec4(0);   // it fills up its list of neighbours
#endif
}
