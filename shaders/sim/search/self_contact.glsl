// Which particles may touch each other.
#include "sim/common/bodies/owners.glsl"
#include "sim/common/contacts/touch.glsl"
#include "sim/common/particles.glsl"

uniform samplerBuffer restPositions;

/// Where a particle is in its assembly.
struct RestPosition {
    vec3 position;   // in the rest pose [m]
    float margin;    // particles nearer than 1 + this at rest, in distances of touch, never touch
};

RestPosition fetchRestPosition(uint i)
{
    vec4 t = texelFetch(restPositions, int(i));
    return RestPosition(t.xyz, t.w);
}

#ifdef FILTERS
#include "sim/search/filter_bits.glsl"

/// Whether two bodies of an assembly never touch.
bool passEachOther(uint a, uint b)
{
    uint bit = passBit(a, b);
    return bit != NONE && (filterBits[bit >> 5] >> (bit & 31u) & 1u) != 0u;
}
#else
bool passEachOther(uint a, uint b)
{
    return false;
}
#endif

/// Whether one body has both, or two bodies that never touch have one each.
bool areTogether(uint i, uint j)
{
    OwnerRange a = fetchOwners(i), b = fetchOwners(j);
    bool same = false, owned = a.count > 0u && b.count > 0u;
    uint k = 0u, l = 0u;
    do {
        uint first = fetchOwner(a.first + k).body, second = fetchOwner(b.first + l).body;
        same = same || first == second || passEachOther(first, second);
        l = l + 1u < b.count ? l + 1u : 0u;
        if (l == 0u) ++k;
    } while (k < a.count && !same);
    return same && owned;
}

/// Whether two particles may touch: within an assembly only if they do not touch or overlap at rest.
bool mayTouch(uint i, uint j)
{
    if (fetchParticle(i).assembly != fetchParticle(j).assembly) return true;
    RestPosition a = fetchRestPosition(i), b = fetchRestPosition(j);
    float least = (0.99 + max(a.margin, b.margin)) * sim.diameter;
    return length(a.position - b.position) > least && !areTogether(i, j);
}
