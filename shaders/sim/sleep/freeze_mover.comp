// One thread a mover: checks whether its farthest particle has moved too far from where its assembly began to count its
// calm steps (paper, section 3.1: freezing). If so, the assembly starts a new count from its current place.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/particles.glsl"
#include "sim/sleep/calm.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
BUFFER(vec4, CalmCentres, calmCentres);
BUFFER(vec4, CalmRotations, calmRotations);
BUFFER(Calm, AssemblyNext, assemblyNext);

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    if (!mayRest(m)) return;
    Mover mover = fetchMover(m);
    bool body = m < sim.bodyCount;
    vec3 centre = body ? fetchCentre(m) : texelFetch(positions, int(fetchRankedParticle(mover.firstRank))).xyz;
    vec4 rotation = fetchRotation(m);
    if (fetchCalm(mover.assembly).steps == 0u) {
        calmCentres[m] = vec4(centre, 0);
        calmRotations[m] = rotation;
        return;
    }
    vec4 delta = quaternionProduct(rotation, conjugate(calmRotations[m]));
    float moved = length(centre - calmCentres[m].xyz) + 2.0 * length(delta.xyz) * moverRadius(m);
    if (moved > sim.freeze) assemblyNext[mover.assembly].steps = 0u;
}
