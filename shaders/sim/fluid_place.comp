// One thread a slot: where its particle is predicted to be at the end of the substep if no pressure acts.
// SETTLE: where it is.
#include "shared/kernel.glsl"
#include "shared/fluid_slots.glsl"
#include "shared/movers.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer velocities;
uniform samplerBuffer masses;            // inverse mass
uniform samplerBuffer restOffsets;
uniform usamplerBuffer particlePlaces;   // mover, rank
BUFFER(vec4, SlotPlaces, slotPlaces);    // w: mass [kg]

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = texelFetch(slotParticles, int(k)).x;
    float h = step.substepTime;
    vec3 v = texelFetch(velocities, int(i)).xyz + h * step.gravity.xyz;
    vec3 x = texelFetch(positions, int(i)).xyz + h * v;
#ifdef SETTLE
    x = texelFetch(positions, int(i)).xyz;
#else
    if (!isFluid(i)) {
        MoverPoint point = moverPoint(texelFetch(particlePlaces, int(i)).x, texelFetch(restOffsets, int(i)).xyz);
        x = point.centre + point.arm + point.move;
    }
#endif
    slotPlaces[k] = vec4(x, 1.0 / max(texelFetch(masses, int(i)).x, 1e-20));
}
