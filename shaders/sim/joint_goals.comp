// One thread a shared particle: its move to the mean of its goals (paper, section 4): the joint. It also works out the
// impulses that its bodies owe each other so that their goals meet; they sum to zero, and are carried to the next match
// as displacements of the particle in each body. LAST: the substep ends, what is left stays as a gap.
#include "shared/kernel.glsl"
#include "shared/goals.glsl"
#include "shared/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedParticles;
uniform samplerBuffer moved;
uniform samplerBuffer masses;
uniform usamplerBuffer particleInfo;
uniform usamplerBuffer particleLinks;
uniform usamplerBuffer linksOfParticle;
uniform samplerBuffer linkMasses;        // effective inverse mass of a link's body at the particle
uniform usamplerBuffer assemblyState;
BUFFER(vec4, Predicted, predicted);
BUFFER(vec4, LinkOffsets, linkOffsets);  // what the next body_sum adds to the particle's move
BUFFER(vec4, LinkGaps, linkGaps);        // mean of goals minus goal, at the end of the last substep

uvec2 owner(uvec2 owned, uint k)
{
    return texelFetch(linksOfParticle, int(owned.x + k)).xy;
}

/// From the goal of link `from` to the mean of all goals' moves: summed from differences of two, so that for two bodies
/// the parts cancel to the last bit.
vec3 toMean(uvec2 owned, uint from)
{
    uvec2 own = owner(owned, from);
    vec3 move = goalMove(own.y, fetchLink(own.x).r);
    vec3 sum = vec3(0);
    for (uint k = 0u; k < owned.y; ++k) {
        uvec2 other = owner(owned, k);
        sum += goalMove(other.y, fetchLink(other.x).r) - move;
    }
    return sum / float(owned.y);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= step.sharedCount) return;
    uint i = texelFetch(sharedParticles, int(k)).x;
    if (texelFetch(masses, int(i)).x == 0.0) {
        predicted[i] = vec4(texelFetch(moved, int(i)).xyz, 0);
        return;
    }
    uvec2 owned = texelFetch(particleLinks, int(i)).xy;
    float bodies = float(owned.y);
    float inverseMass = 0.0;
    for (uint l = 0u; l < owned.y; ++l)
        inverseMass += texelFetch(linkMasses, int(owner(owned, l).x)).x * splits(owner(owned, l).y);
    float factor = forceFactor(texelFetch(assemblyState, int(texelFetch(particleInfo, int(i)).z)).y);
    for (uint l = 0u; l < owned.y; ++l) {
        uint linkIndex = owner(owned, l).x;
        vec3 gap = linkGaps[linkIndex].xyz + toMean(owned, l);
#ifdef LAST
        linkGaps[linkIndex] = vec4(gap, 0);
        linkOffsets[linkIndex] = vec4(0);
#else
        float scale = step.jointRelaxation * bodies / (inverseMass * fetchLink(linkIndex).mass * factor);
        linkOffsets[linkIndex] = vec4(scale * gap, 0);
#endif
    }
    uvec2 first = owner(owned, 0u);
    vec3 move = goalMove(first.y, fetchLink(first.x).r) + toMean(owned, 0u);
    predicted[i] = vec4(move, inverseMass / (bodies * bodies));
}
