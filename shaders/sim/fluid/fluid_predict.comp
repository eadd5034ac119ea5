// One thread a fluid particle: its predicted position at the end of the step's first substep without pressure; for
// later substeps, fluid_pressure predicts it. RELAX: its position.
#include "sim/common/kernel.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/pressure/slot_pressures.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/common/fluid_past.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer velocities;
uniform samplerBuffer fluidPasts;
BUFFER(vec4, SlotPositions, newSlotPositions);
BUFFER(vec4, SlotMoves, newSlotMoves);

void main()
{
    if (gl_GlobalInvocationID.x >= sim.fluidCount) return;
    uint i = sim.particleCount + gl_GlobalInvocationID.x;
    FluidPosition own = fluidPosition(texelFetch(positions, int(i)));
    if (own.inactive) return;
#ifdef RELAX
    vec3 x = own.position;
#else
    vec3 x = predictedPosition(own.position, texelFetch(velocities, int(i)).xyz);
#endif
    FluidPast past = fluidPast(texelFetch(fluidPasts, int(i)));
    newSlotMoves[fetchParticleSlot(i)] = pack(SlotMove(x - past.position, past.compression == JUST_EMITTED));
    newSlotPositions[fetchParticleSlot(i)] = pack(SlotPosition(x, 1.0 / max(fetchMass(i).inverseMass, 1e-20)));
}
