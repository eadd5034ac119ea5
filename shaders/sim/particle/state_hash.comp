// One thread hashes some particles and adds them to the hash of the state: whole numbers, whose sum does not depend on
// the order of threads.
#include "sim/common/kernel.glsl"
#include "shared/state_hash.h"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(vec4, Positions, positions);
READ_BUFFER(vec4, Velocities, velocities);
BUFFER(uint, StateHash, stateHash);

uint hashOf(uint seed, uint particle)
{
    uint hash = mixedHash(seed, particle);
    uvec3 place = floatBitsToUint(positions[particle].xyz), velocity = floatBitsToUint(velocities[particle].xyz);
    for (int k = 0; k < 3; ++k) hash = mixedHash(hash, place[k]);
    for (int k = 0; k < 3; ++k) hash = mixedHash(hash, velocity[k]);
    return hash;
}

void main()
{
    uint count = sim.particleCount + sim.fluidCount;
    uint first = gl_GlobalInvocationID.x * HASHED_PARTICLES;
    uint low = 0u, high = 0u;
    for (uint i = first; i < min(first + HASHED_PARTICLES, count); ++i) {
        low += hashOf(STATE_HASH_LOW, i);
        high += hashOf(STATE_HASH_HIGH, i);
    }
    if (first >= count) return;
    atomicAdd(stateHash[0], low);
    atomicAdd(stateHash[1], high);
}
