// One thread a body that may be let go: if it is let go in this substep, notes how its velocity changes. BEFORE: at the
// start of the substep, notes the velocity. After it, notes the change beyond what gravity, wind, fields and contacts
// (also with fluids and ropes) give, the part of that from joints, and the change by contacts.
#define BODIES
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/body_rows.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/outside.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer bodyReleases;
uniform samplerBuffer moverVelocities;
#ifndef BEFORE
#include "sim/common/bodies/assemblies.glsl"
uniform samplerBuffer bodyPushes;
#endif
BUFFER(vec4, ReleaseNotes, releaseNotes);   // three a body [m/s]
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.releaseCount) return;
    uvec2 release = texelFetch(bodyReleases, int(k)).xy;
    vec3 velocity = fetchField(moverVelocities, release.x).t;
#ifdef BEFORE
    if (release.y == counters[0].substep) releaseNotes[3u * k] = vec4(velocity, 0);
#else
    if (release.y + 1u != counters[0].substep) return;
    Mover body = fetchMover(release.x);
    Assembly assembly = fetchAssembly(body.assembly);
    bool second = assembly.order == 2u && assembly.lastContact + 1u != counters[0].substep;
    // The velocity that an impulse of one kg m gives to the body: for BDF2, that of one and a half moves.
    float response = (second ? 1.5 : 1.0) * body.inverseMass / sim.substepTime;
    vec3 contacts = response * fetchField(bodyPushes, release.x).t;
    vec3 given = sim.substepTime * outsideAcceleration(release.x) + contacts;
    vec3 joints = response * rowSum(release.x, vec4(0, 0, 0, 1)).t;
    releaseNotes[3u * k + 1u] = vec4(velocity - releaseNotes[3u * k].xyz - given, 0);
    releaseNotes[3u * k + 2u] = vec4(joints, length(contacts));
#endif
}
