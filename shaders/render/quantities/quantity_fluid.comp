// One thread a particle: the density of its fluid over that at rest, or (PRESSURE) the pressure [Pa], both of the last
// substep. The solver has them by slot (sim/fluid/pressure/slot_pressures.glsl, sim/fluid/walls/slot_covers.glsl).
#include "render/quantities/input.glsl"

uniform usamplerBuffer particleSlots;
uniform usamplerBuffer slotParticles;
#ifdef PRESSURE
uniform usamplerBuffer slotPressures;
uniform samplerBuffer slotShapes;
layout(location = 0) uniform float pressureUnit;   // of a stored multiplier [Pa]

// The multiplier without what evens its stress.
float valueOf(int slot)
{
    vec3 lambda = uintBitsToFloat(texelFetch(slotPressures, 2 * slot + 1).xyz);
    vec4 shape = texelFetch(slotShapes, 2 * slot), rest = texelFetch(slotShapes, 2 * slot + 1);
    return -pressureUnit * (lambda.x + lambda.y + lambda.z) / (shape.x + rest.x + rest.z);
}
#else
uniform samplerBuffer slotCovers;

float valueOf(int slot)
{
    return texelFetch(slotCovers, slot).w;
}
#endif

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= frame.particleCount) return;
    // What has come since the last step has no slot yet.
    uint slot = min(texelFetch(particleSlots, int(i)).x, frame.particleCount - 1u);
    bool isThere = i >= frame.solidCount && texelFetch(slotParticles, int(slot)).x == i;
    shownQuantities[i] = isThere ? valueOf(int(slot)) : NO_QUANTITY;
}
