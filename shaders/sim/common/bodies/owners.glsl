// The bodies that own a particle, by its links.

uniform usamplerBuffer particleLinks;
uniform usamplerBuffer linksOfParticle;

/// Entries of linksOfParticle.
struct OwnerRange {
    uint first, count;
};

OwnerRange fetchOwners(uint particle)
{
    uvec2 t = texelFetch(particleLinks, int(particle)).xy;
    return OwnerRange(t.x, t.y);
}

struct Owner {
    uint link, body;
};

Owner fetchOwner(uint entry)
{
    uvec2 t = texelFetch(linksOfParticle, int(entry)).xy;
    return Owner(t.x, t.y);
}
