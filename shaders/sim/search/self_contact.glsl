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

bool inSameBody(uint i, uint j)
{
    OwnerRange a = fetchOwners(i), b = fetchOwners(j);
    bool same = false;
    for (uint k = 0u; k < a.count; ++k)
        for (uint l = 0u; l < b.count; ++l)
            same = same || fetchOwner(a.first + k).body == fetchOwner(b.first + l).body;
    return same;
}

/// For two particles of one assembly: only where they do not touch or overlap at rest.
bool mayTouch(uint i, uint j)
{
    RestPosition a = fetchRestPosition(i), b = fetchRestPosition(j);
    float least = (0.99 + max(a.margin, b.margin)) * touchDistance(i, j);
    return length(a.position - b.position) > least && !inSameBody(i, j);
}
