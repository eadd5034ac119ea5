// One thread a particle that two bodies share: the impulses that they owe each other so that their goals for it meet.
// Particles of three or more bodies are joint_solve_many's business.
#include "sim/common/kernel.glsl"
#include "sim/joint/joint_impulse.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedOwners;     // the one link and its body, the other

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.sharedByTwo) return;
    uvec4 owners = texelFetch(sharedOwners, int(k));
    Owner a = Owner(owners.x, owners.y), b = Owner(owners.z, owners.w);
    // Both from the first body's goal, so that the impulses cancel to the last bit.
    vec3 difference = goal(b, goal(a, vec3(0)));
    vec3 impulse = impulseScale(splitInverseMass(a) + splitInverseMass(b)) * difference;
    setImpulse(a.link, impulse);
    setImpulse(b.link, -impulse);
}
