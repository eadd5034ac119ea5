// In which bodies a particle is: its links, one a body.

uniform usamplerBuffer particleLinks;    // by particle: its range of linksOfParticle
uniform usamplerBuffer linksOfParticle;

/// The links of a particle: entries of linksOfParticle.
struct LinkRange {
    uint first, count;
};

LinkRange fetchLinkRange(uint particle)
{
    uvec2 t = texelFetch(particleLinks, int(particle)).xy;
    return LinkRange(t.x, t.y);
}

/// A link, and the body that owns it.
struct OwnedLink {
    uint link, body;
};

OwnedLink fetchOwnedLink(uint entry)
{
    uvec2 t = texelFetch(linksOfParticle, int(entry)).xy;
    return OwnedLink(t.x, t.y);
}
