// One thread a slot, before pressures: where its particle is when the substep begins, and how a solid one moves.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/viscous/viscous_materials.glsl"
#include "sim/fluid/viscous/viscous_slots.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
BUFFER(vec4, SlotStarts, newSlotStarts);
BUFFER(vec4, SlotGoals, newSlotGoals);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k);
    SlotStart start = SlotStart(texelFetch(positions, int(i)).xyz, 0.0);
    if (isFluid(i)) start.grip = fetchViscousMaterial(fetchParticle(i).material).solidGrip;
    else {
        uint mover = fetchRank(i).mover;
        MoverPoint point = moverPoint(mover, fetchArm(i).r);
        start.position = point.centre + point.arm;
        float inverseMass = responds(mover) ? fetchMass(i).inverseMass : 0.0;
        newSlotGoals[k] = pack(SlotGoal(point.move / sim.substepTime, inverseMass));
    }
    newSlotStarts[k] = pack(start);
}
