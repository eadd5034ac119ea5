// Which particles of one assembly may touch each other.
#include "sim/common/bodies/owners.glsl"
#include "sim/common/contacts/touch.glsl"

uniform samplerBuffer restPositions;

/// Where a particle is in its assembly.
struct RestPosition {
    vec3 position;   // in the rest pose [m]
    float margin;    // nearer than 1 + this there, in distances of touch, particles never touch
};

RestPosition fetchRestPosition(uint i)
{
    vec4 t = texelFetch(restPositions, int(i));
    return RestPosition(t.xyz, t.w);
}

#ifdef PASSES
#include "sim/common/bodies/body_passes.glsl"
READ_BUFFER(uint, PassBits, passBits);

/// Whether two bodies of an assembly never touch.
bool passEachOther(uint a, uint b)
{
    uint bit = passBit(a, b);
    return bit != NONE && (passBits[bit >> 5] >> (bit & 31u) & 1u) != 0u;
}
#else
bool passEachOther(uint a, uint b)
{
    return false;
}
#endif

/// Whether a body has both, or each is of one of two that never touch.
bool areTogether(uint i, uint j)
{
    OwnerRange a = fetchOwners(i), b = fetchOwners(j);
    bool same = false;
    for (uint k = 0u; k < a.count; ++k)
        for (uint l = 0u; l < b.count; ++l) {
            uint first = fetchOwner(a.first + k).body, second = fetchOwner(b.first + l).body;
            same = same || first == second || passEachOther(first, second);
        }
    return same;
}

/// For two particles of one assembly: only where they do not touch or overlap at rest.
bool mayTouch(uint i, uint j)
{
    RestPosition a = fetchRestPosition(i), b = fetchRestPosition(j);
    float least = (0.99 + max(a.margin, b.margin)) * touchDistance(i, j);
    return length(a.position - b.position) > least && !areTogether(i, j);
}
