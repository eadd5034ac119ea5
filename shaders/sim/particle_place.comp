// One thread a particle: where its body has it (eq. 8), with which velocity. A particle that bodies share stands at the
// mean of its goals (section 4), or where a fixed body holds it.
#include "shared/kernel.glsl"
#include "shared/fields.glsl"
#include "shared/quaternion.glsl"
#include "shared/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverCentres;
uniform samplerBuffer moverRotations;
uniform samplerBuffer moverVelocities;
uniform samplerBuffer masses;
uniform samplerBuffer restOffsets;
uniform usamplerBuffer particlePlaces;   // mover, rank
uniform usamplerBuffer particleLinks;
uniform usamplerBuffer linksOfParticle;
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount || texelFetch(masses, int(i)).x == 0.0) return;
    uint mover = texelFetch(particlePlaces, int(i)).x;
    vec3 r = texelFetch(restOffsets, int(i)).xyz;
    Field velocity = fetchField(moverVelocities, mover);
    vec3 x = texelFetch(moverCentres, int(mover)).xyz + rotate(texelFetch(moverRotations, int(mover)), r);
    vec3 v = velocity.t + velocity.f * r;
    uvec2 owned = texelFetch(particleLinks, int(i)).xy;
    vec3 shift = vec3(0), change = vec3(0);
    for (uint k = owned.x + 1u; k < owned.x + owned.y; ++k) {
        uvec2 owner = texelFetch(linksOfParticle, int(k)).xy;
        vec3 s = fetchLink(owner.x).r;
        Field other = fetchField(moverVelocities, owner.y);
        shift += texelFetch(moverCentres, int(owner.y)).xyz + rotate(texelFetch(moverRotations, int(owner.y)), s) - x;
        change += other.t + other.f * s - v;
    }
    float bodies = float(max(owned.y, 1u));
    positions[i].xyz = x + shift / bodies;
    velocities[i] = vec4(v + change / bodies, 0);
}
