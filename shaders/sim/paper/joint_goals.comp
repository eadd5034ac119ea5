// One thread a shared particle: its move to the mean of its goals (paper, section 4): the joint. In the next match of
// each body it is placed so far beyond the mean that the body's goal gets there: its own mass alone would draw a body
// of 27 by a thirtieth of the gap. STABILIZE: it starts from the mean.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/owners.glsl"
#include "sim/common/particles.glsl"
#include "sim/paper/goals.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedParticles;
uniform samplerBuffer moved;
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
    OwnerRange owners = fetchOwners(i);
    vec3 sum = vec3(0);
    for (uint l = owners.first; l < owners.first + owners.count; ++l) {
        Owner owner = fetchOwner(l);
        sum += goalMove(owner.body, fetchLink(owner.link).r);
    }
    bool matched = responds(fetchRank(i).mover);
    vec3 mean = matched ? sum / float(owners.count) : texelFetch(moved, int(i)).xyz;
#ifdef STABILIZE
    vec3 position = positions[i].xyz + mean;
    positions[i].xyz = position;
#else
    vec3 position = texelFetch(positions, int(i)).xyz + mean;
    predicted[i].xyz = mean;
#endif
    for (uint l = owners.first; l < owners.first + owners.count; ++l) {
        Owner owner = fetchOwner(l);
        vec3 gap = position - goalPosition(owner.body, fetchLink(owner.link).r);
        float bound = min(1.0, sim.jointCorrection / max(length(gap), 1e-20));
        linkPulls[owner.link] = vec4(texelFetch(linkGains, int(owner.link)).x * bound * gap, 0);
    }
}
