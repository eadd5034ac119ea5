// One thread a shared particle: its move to the mean of its goals (paper, section 4): the joint. In the next match of
// each body it stands beyond the mean, by as much as brings the body's goal to it: with its own mass alone it would draw
// a body of 27 by a thirtieth of the gap. STABILIZE: it starts from the mean.
#include "sim/common/kernel.glsl"
#include "sim/paper/goals.glsl"
#include "sim/common/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedParticles;
uniform samplerBuffer moved;
uniform samplerBuffer masses;
uniform usamplerBuffer particleLinks;
uniform usamplerBuffer linksOfParticle;
uniform samplerBuffer linkGains;
BUFFER(vec4, LinkPulls, linkPulls);
#ifdef STABILIZE
BUFFER(vec4, Positions, positions);
#else
uniform samplerBuffer positions;
BUFFER(vec4, Predicted, predicted);
#endif

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.sharedCount) return;
    uint i = texelFetch(sharedParticles, int(k)).x;
    uvec2 owned = texelFetch(particleLinks, int(i)).xy;
    vec3 sum = vec3(0);
    for (uint l = owned.x; l < owned.x + owned.y; ++l) {
        uvec2 owner = texelFetch(linksOfParticle, int(l)).xy;
        sum += goalMove(owner.y, fetchLink(owner.x).r);
    }
    bool held = texelFetch(masses, int(i)).x > 0.0;
    vec3 mean = held ? sum / float(owned.y) : texelFetch(moved, int(i)).xyz;
#ifdef STABILIZE
    vec3 place = positions[i].xyz + mean;
    positions[i].xyz = place;
#else
    vec3 place = texelFetch(positions, int(i)).xyz + mean;
    predicted[i].xyz = mean;
#endif
    for (uint l = owned.x; l < owned.x + owned.y; ++l) {
        uvec2 owner = texelFetch(linksOfParticle, int(l)).xy;
        vec3 gap = place - goalPlace(owner.y, fetchLink(owner.x).r);
        float bound = min(1.0, sim.jointCorrection / max(length(gap), 1e-20));
        linkPulls[owner.x] = vec4(texelFetch(linkGains, int(owner.x)).x * bound * gap, 0);
    }
}
