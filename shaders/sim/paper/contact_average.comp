// One thread a particle: one iteration of count-averaged Jacobi over its contacts (eqs. 3-7; Macklin et al. 2014, 4.2).
// The match of a body averages over all its particles once more; over-relaxation makes up for that, as far as the body
// does not answer by more than is asked. STABILIZE: how far the particle has to move out of the overlaps that it starts
// in (their 4.4).
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/particles.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/paper/body_acting.glsl"
#include "sim/paper/contact_pushes.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(BodyActingSums, BodyActing, bodyActing);
BUFFER(Assembly, AssemblyState, assemblies);
BUFFER(vec4, Moved, moved);              // predicted move plus what contacts ask for [m]; STABILIZE: only the latter
READ_BUFFER(Counters, CountersBlock, counters);

/// The factor by which a particle of a body is moved further than its contacts ask, since the match passes on only its
/// fraction. Also counts it as pushed.
float bodyRelaxation(uint i, uint body, Push push)
{
    float fraction = fetchArm(i).worstInverseMass / fetchMass(i).inverseMass;
    if (push.acting > 0.0) atomicAdd(bodyActing[body].now, uint(fraction * FRACTION_PARTS));
    float sum = float(bodyActing[body].last) / FRACTION_PARTS;
    float most = min(1.0 / fraction, MOST_FRACTION_SUM / max(sum, 1e-6));
#ifdef STABILIZE
    return most;
#else
    return min(most, sim.overRelaxation);
#endif
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    Particle info = fetchParticle(i);
    if (!responds(fetchRank(i).mover)) {
        moved[i] = vec4(0);
        return;
    }
    Side own = fetchSide(i);
    Push sum = allPushes(i, own, counters[0].listParity, fetchRank(i).rank);
    if (sum.acting > 0.0) assemblies[info.assembly].lastContact = counters[0].substep - 1u;
    float relaxation = info.bodyCount > 0u && own.inverseMass > 0.0 ? bodyRelaxation(i, info.body, sum) : 1.0;
    vec3 push = relaxation / max(sum.acting, 1.0) * sum.move;
#ifdef STABILIZE
    moved[i] = vec4(push, 0);
#else
    moved[i] = vec4(own.move + push, 0);
#endif
}
