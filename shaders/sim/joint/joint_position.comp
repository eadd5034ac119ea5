// One thread a particle that bodies share: it stands at the mean of their goals (section 4), or where a fixed body
// holds it.
#include "sim/common/kernel.glsl"
#include "sim/common/mover_state.glsl"
#include "sim/common/links.glsl"
#include "sim/common/mover_info.glsl"
#include "sim/common/owners.glsl"
#include "sim/common/particles.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sharedParticles;
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);

PointState goalOf(uint entry)
{
    Owner owned = fetchOwner(entry);
    return pointState(owned.body, fetchLink(owned.link).r);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.sharedCount) return;
    uint i = texelFetch(sharedParticles, int(k)).x;
    if (isFixed(fetchRank(i).mover)) return;   // where a fixed body has it, that is the first of its bodies
    OwnerRange range = fetchOwners(i);
    // From the first goal, so that rounding stays as small as what is between them.
    PointState first = goalOf(range.first);
    vec3 shift = vec3(0), change = vec3(0);
    for (uint l = range.first + 1u; l < range.first + range.count; ++l) {
        PointState other = goalOf(l);
        shift += other.position - first.position;
        change += other.velocity - first.velocity;
    }
    positions[i].xyz = first.position + shift / float(range.count);
    velocities[i] = vec4(first.velocity + change / float(range.count), 0);
}
