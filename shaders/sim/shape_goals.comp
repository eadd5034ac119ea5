// One thread a particle: its move to its goal Q r + c (eq. 8), to the mean of its goals where bodies share it: the
// paper's joint. A
// shared particle also works out the impulses that its bodies owe each other there; they are carried as displacements
// of its links, sum to zero, and let `correction` of an old gap be taken back per substep.
#include "shared/kernel.glsl"
#include "shared/quaternion.glsl"
#include "shared/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moved;
uniform samplerBuffer masses;
uniform samplerBuffer restOffsets;       // r of the first body, effective inverse mass in it
uniform usamplerBuffer particleInfo;
uniform usamplerBuffer particleLinks;
uniform usamplerBuffer linksOfParticle;
uniform samplerBuffer linkMasses;        // effective inverse mass of a link's body at the particle
uniform samplerBuffer bodyStarts;        // centre, rotation at the start of the substep
uniform samplerBuffer bodyMoves;         // of the centre since; w: contacts
uniform samplerBuffer bodyRotations;
uniform usamplerBuffer bodyInfo;
uniform usamplerBuffer assemblyState;
BUFFER(vec4, Predicted, predicted);
BUFFER(vec4, LinkOffsets, linkOffsets);  // what the next body_sum adds to the particle's position
BUFFER(vec4, LinkImpulses, linkImpulses);  // accumulated, as displacement of the link's mass
BUFFER(vec4, LinkGaps, linkGaps);        // mean of goals minus goal, at the end of the last substep

/// How far the goal of r has moved in the substep [m]: a difference of rotations, not of positions, so that rounding
/// stays as small as the move.
vec3 goalMove(uint body, vec3 r)
{
    vec4 before = texelFetch(bodyStarts, int(2u * body + 1u));
    return texelFetch(bodyMoves, int(body)).xyz + rotate(texelFetch(bodyRotations, int(body)), r) - rotate(before, r);
}

/// Over how many constraints a body's mass is split.
float splits(uint body)
{
    return texelFetch(bodyMoves, int(body)).w + float(texelFetch(bodyInfo, int(body)).w);
}

vec4 sharedGoal(uint i, uint assembly)
{
    uvec2 owned = texelFetch(particleLinks, int(i)).xy;
    float bodies = float(owned.y);
    vec3 mean = vec3(0);
    float inverseMass = 0.0;
    for (uint k = 0u; k < owned.y; ++k) {
        uvec2 linkBody = texelFetch(linksOfParticle, int(owned.x + k)).xy;
        mean += goalMove(linkBody.y, fetchLink(linkBody.x).r);
        inverseMass += texelFetch(linkMasses, int(linkBody.x)).x * splits(linkBody.y);
    }
    mean /= bodies;
    float factor = forceFactor(texelFetch(assemblyState, int(assembly)).y);
    for (uint k = 0u; k < owned.y; ++k) {
        uvec2 linkBody = texelFetch(linksOfParticle, int(owned.x + k)).xy;
        LinkValues link = fetchLink(linkBody.x);
        vec3 opened = mean - goalMove(linkBody.y, link.r);
#ifdef LAST
        linkGaps[linkBody.x].xyz += opened;
        linkOffsets[linkBody.x] = step.jointWarmStart * linkImpulses[linkBody.x];
        linkImpulses[linkBody.x] *= step.jointWarmStart;
#else
        vec3 error = opened + step.jointCorrection * linkGaps[linkBody.x].xyz;
        float scale = step.jointRelaxation * bodies / (inverseMass * link.mass * factor);
        linkOffsets[linkBody.x] = vec4(scale * error, 0);
        linkImpulses[linkBody.x].xyz += scale * error;
#endif
    }
    return vec4(mean, inverseMass / (bodies * bodies));
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    uvec4 info = texelFetch(particleInfo, int(i));
    vec4 x = texelFetch(moved, int(i));
    float inverseMass = texelFetch(masses, int(i)).x;
    vec4 result = vec4(x.xyz, inverseMass * max(x.w, 1.0));
    if (inverseMass > 0.0 && info.y == 1u) {
        vec4 offset = texelFetch(restOffsets, int(i));
        result = vec4(goalMove(info.x, offset.xyz), offset.w * max(splits(info.x), 1.0));
    } else if (inverseMass > 0.0 && info.y > 1u)
        result = sharedGoal(i, info.z);
    predicted[i] = result;
}
