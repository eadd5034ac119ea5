// One thread a shared particle: the impulses that its bodies owe each other so that their goals for it meet. They sum
// to zero. FIRST: of a substep; joints have no memory.
#include "shared/kernel.glsl"
#include "shared/movers.glsl"
#include "shared/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedParticles;
uniform usamplerBuffer particleLinks;
uniform usamplerBuffer linksOfParticle;
uniform samplerBuffer moverChanges;      // w of the first of four: relaxation of contacts
uniform samplerBuffer linkMasses;        // effective inverse mass of a link's body at the particle
BUFFER(vec4, LinkImpulses, linkImpulses);

/// Where link's body would have the particle, from `origin`.
vec3 goal(uvec2 owner, vec3 origin)
{
    MoverPoint point = moverPoint(owner.y, fetchLink(owner.x).r);
    return point.centre - origin + (point.arm + point.move);
}

float splitInverseMass(uvec2 owner)
{
    float relaxation = texelFetch(moverChanges, int(4u * owner.y)).w;
    return texelFetch(linkMasses, int(owner.x)).x * texelFetch(moverMoves, int(owner.y)).w * relaxation;
}

void setImpulse(uint link, vec3 impulse)
{
#ifdef FIRST
    linkImpulses[link] = vec4(impulse, 0);
#else
    linkImpulses[link].xyz += impulse;
#endif
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= step.sharedCount) return;
    uvec2 owned = texelFetch(particleLinks, int(texelFetch(sharedParticles, int(k)).x)).xy;
    // All from the first body's goal: of two bodies the impulses then cancel to the last bit.
    uvec2 first = texelFetch(linksOfParticle, int(owned.x)).xy;
    vec3 origin = goal(first, vec3(0)), sum = vec3(0);
    float inverseMass = splitInverseMass(first);
    for (uint l = owned.x + 1u; l < owned.x + owned.y; ++l) {
        uvec2 owner = texelFetch(linksOfParticle, int(l)).xy;
        inverseMass += splitInverseMass(owner);
        sum += goal(owner, origin);
    }
    float scale = inverseMass > 0.0 ? step.jointRelaxation / inverseMass : 0.0;
    setImpulse(first.x, scale * sum);
    for (uint l = owned.x + 1u; l < owned.x + owned.y; ++l) {
        uvec2 owner = texelFetch(linksOfParticle, int(l)).xy;
        setImpulse(owner.x, scale * (sum - float(owned.y) * goal(owner, origin)));
    }
}
