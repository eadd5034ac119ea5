// One thread a chunk of slots: lists the slots of the points that the step makes.
#include "sim/common/kernel.glsl"
#include "sim/common/fluid_particles.glsl"
#include "sim/fluid/foam/foam_points.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer foamBirths;
uniform usamplerBuffer foamSums;
uniform usamplerBuffer foamRing;
BUFFER(uint, FoamParents, newFoamParents);

void main()
{
    uint slots = slotCount(), first = gl_GlobalInvocationID.x * SCAN_CHUNK;
    if (first >= slots) return;
    uint rank = texelFetch(foamSums, int(gl_GlobalInvocationID.x)).x;
    uint stride = ringStateOf(texelFetch(foamRing, FOAM_RING)).stride;
    for (uint k = first; k < min(first + SCAN_CHUNK, slots); ++k) {
        uint end = rank + texelFetch(foamBirths, int(k)).x;
        for (; rank < end; ++rank)
            if (rank % stride == 0u) newFoamParents[rank / stride] = k;
    }
}
