// One thread a particle that two bodies share: the impulses that they owe each other so that their goals for it meet.
// Particles of three or more bodies are joint_solve_many's business.
#include "sim/common/kernel.glsl"
#include "sim/joint/joint_impulse.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedOwners;     // link and body of the one, of the other

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.sharedByTwo) return;
    uvec4 owners = texelFetch(sharedOwners, int(k));
    // Both from the first body's goal, so that the impulses cancel to the last bit.
    vec3 apart = goal(owners.zw, goal(owners.xy, vec3(0)));
    vec3 impulse = impulseScale(splitInverseMass(owners.xy) + splitInverseMass(owners.zw)) * apart;
    setImpulse(owners.x, impulse);
    setImpulse(owners.z, -impulse);
}
