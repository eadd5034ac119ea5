// One thread a slot: gives its particle what viscosity has changed. A fluid particle ends its substep and predicts the
// next; a solid one gets an impulse.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/viscous/viscous_slots.glsl"
#include "sim/fluid/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotFlows;
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(vec4, SlotPositions, newSlotPositions);
BUFFER(vec4, ParticleImpulses, particleImpulses);
BUFFER(Assembly, AssemblyState, assemblies);
BUFFER(uint, ViscousStiffness, viscousStiffness);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k == 0u) viscousStiffness[0] = 0u;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k);
    SlotGoal goal = fetchSlotGoal(k);
    vec3 before = isFluid(i) ? velocities[i].xyz : goal.velocity;
    vec3 change = flowOf(texelFetch(slotFlows, int(k))).velocity - before, way = sim.substepTime * change;
    if (change == vec3(0)) return;
    if (isFluid(i)) {
        velocities[i].xyz += change;
        positions[i].xyz += way;
        newSlotPositions[k].xyz = predictedPosition(positions[i].xyz, velocities[i].xyz);
        return;
    }
    // Like contacts, this makes its assembly end the substep by first order.
    assemblies[fetchParticle(i).assembly].lastContact = counters[0].substep - 1u;
    particleImpulses[fetchRank(i).rank].xyz += way / goal.inverseMass;
}
