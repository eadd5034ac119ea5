// One thread a shared particle: its move to the mean of its goals (paper, section 4): the joint.
#include "shared/kernel.glsl"
#include "shared/goals.glsl"
#include "shared/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedParticles;
uniform samplerBuffer moved;
uniform samplerBuffer masses;
uniform usamplerBuffer particleLinks;
uniform usamplerBuffer linksOfParticle;
BUFFER(vec4, Predicted, predicted);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= step.sharedCount) return;
    uint i = texelFetch(sharedParticles, int(k)).x;
    uvec2 owned = texelFetch(particleLinks, int(i)).xy;
    vec3 sum = vec3(0);
    for (uint l = owned.x; l < owned.x + owned.y; ++l) {
        uvec2 owner = texelFetch(linksOfParticle, int(l)).xy;
        sum += goalMove(owner.y, fetchLink(owner.x).r);
    }
    bool held = texelFetch(masses, int(i)).x > 0.0;
    predicted[i] = vec4(held ? sum / float(owned.y) : texelFetch(moved, int(i)).xyz, 0);
}
