// One thread a particle that three or more bodies share: the impulses that draw each to the mean of their goals. They
// sum to zero.
#include "sim/common/kernel.glsl"
#include "sim/joint/joint_impulse.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedParticles;
uniform usamplerBuffer particleLinks;
uniform usamplerBuffer linksOfParticle;

void main()
{
    uint k = sim.sharedByTwo + gl_GlobalInvocationID.x;
    if (k >= sim.sharedCount) return;
    uvec2 owned = texelFetch(particleLinks, int(texelFetch(sharedParticles, int(k)).x)).xy;
    uvec2 first = texelFetch(linksOfParticle, int(owned.x)).xy;
    vec3 origin = goal(first, vec3(0)), sum = vec3(0);
    float inverseMass = splitInverseMass(first);
    for (uint l = owned.x + 1u; l < owned.x + owned.y; ++l) {
        uvec2 owner = texelFetch(linksOfParticle, int(l)).xy;
        inverseMass += splitInverseMass(owner);
        sum += goal(owner, origin);
    }
    float scale = impulseScale(inverseMass);
    setImpulse(first.x, scale * sum);
    for (uint l = owned.x + 1u; l < owned.x + owned.y; ++l) {
        uvec2 owner = texelFetch(linksOfParticle, int(l)).xy;
        setImpulse(owner.x, scale * (sum - float(owned.y) * goal(owner, origin)));
    }
}
