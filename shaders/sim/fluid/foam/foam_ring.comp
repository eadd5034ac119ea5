// One thread: where in the ring the step's points go, and how many there are.
#include "sim/common/kernel.glsl"
#include "sim/common/groups.glsl"
#include "sim/common/fluid_particles.glsl"
#include "sim/fluid/foam/foam_points.glsl"

layout(local_size_x = 1) in;
uniform usamplerBuffer foamBirths;
uniform usamplerBuffer foamSums;        // per chunk of slots: points before it
BUFFER(uvec4, FoamRing, foamRing);

void main()
{
    uint slots = slotCount(), chunk = (max(slots, 1u) - 1u) / SCAN_CHUNK;
    uint wanted = texelFetch(foamSums, int(chunk)).x;
    for (uint k = chunk * SCAN_CHUNK; k < slots; ++k) wanted += texelFetch(foamBirths, int(k)).x;
    uint stride = max((wanted + mostBorn() - 1u) / mostBorn(), 1u), born = (wanted + stride - 1u) / stride;
    RingState ring = ringStateOf(foamRing[FOAM_RING]);
    uint head = (ring.head + born) % sim.foamCapacity, used = min(ring.used + born, sim.foamCapacity);
    foamRing[FOAM_ADVANCE_SIZE] = uvec4(groups(used), 1, 1, 0);
    foamRing[FOAM_BIRTH_SIZE] = uvec4(groups(born), 1, 1, 0);
    foamRing[FOAM_RING] = uvec4(head, used, ring.head, stride);
    foamRing[FOAM_BORN] = uvec4(born, 0, 0, 0);
}
