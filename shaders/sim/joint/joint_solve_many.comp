// One thread a particle that three or more bodies share: the impulses that draw each to the mean of their goals. They
// sum to zero.
#include "sim/common/kernel.glsl"
#include "sim/joint/joint_impulse.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedParticles;

void main()
{
    uint k = sim.sharedByTwo + gl_GlobalInvocationID.x;
    if (k >= sim.sharedCount) return;
    OwnerRange range = fetchOwners(texelFetch(sharedParticles, int(k)).x);
    Owner first = fetchOwner(range.first);
    vec3 origin = goal(first, vec3(0)), sum = vec3(0);
    float inverseMass = splitInverseMass(first);
    for (uint l = range.first + 1u; l < range.first + range.count; ++l) {
        Owner owned = fetchOwner(l);
        inverseMass += splitInverseMass(owned);
        sum += goal(owned, origin);
    }
    float scale = impulseScale(inverseMass);
    setImpulse(first.link, scale * sum);
    for (uint l = range.first + 1u; l < range.first + range.count; ++l) {
        Owner owned = fetchOwner(l);
        setImpulse(owned.link, scale * (sum - float(range.count) * goal(owned, origin)));
    }
}
