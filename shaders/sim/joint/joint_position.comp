// One thread a particle that bodies share: it stands at the mean of their goals (section 4), or where a fixed body
// holds it.
#include "sim/common/kernel.glsl"
#include "sim/common/mover_state.glsl"
#include "sim/common/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedParticles;
uniform samplerBuffer masses;
uniform usamplerBuffer particleLinks;
uniform usamplerBuffer linksOfParticle;
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);

PointState goalOf(uint place)
{
    uvec2 owner = texelFetch(linksOfParticle, int(place)).xy;
    return pointState(owner.y, fetchLink(owner.x).r);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.sharedCount) return;
    uint i = texelFetch(sharedParticles, int(k)).x;
    if (texelFetch(masses, int(i)).x == 0.0) return;
    uvec2 owned = texelFetch(particleLinks, int(i)).xy;
    // From the first goal, so that rounding stays as small as what is between them.
    PointState first = goalOf(owned.x);
    vec3 shift = vec3(0), change = vec3(0);
    for (uint l = owned.x + 1u; l < owned.x + owned.y; ++l) {
        PointState other = goalOf(l);
        shift += other.position - first.position;
        change += other.velocity - first.velocity;
    }
    positions[i].xyz = first.position + shift / float(owned.y);
    velocities[i] = vec4(first.velocity + change / float(owned.y), 0);
}
