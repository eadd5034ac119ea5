// One thread a mover: adds the change by its collisions' impulses to its velocity. DETECT: counts the impulses. REACH:
// notes that blows have come this far. BEGIN: takes back what was passed on, of its place as well, so that it does not
// stay in what struck it, and notes the velocity without bounces.
#define PAIR_IMPULSES pairRestitutions
#define COLLIDER_IMPULSES colliderRestitutions
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/contacts/impulse_sums.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/restitution/blows.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer lastMoverVelocities;
BUFFER(vec4, MoverVelocities, moverVelocities);
#ifdef BEGIN
BUFFER(vec4, MoverSolvedVelocities, moverSolvedVelocities);
BUFFER(vec4, MoverCentres, nextCentres);
BUFFER(vec4, OldMoverMoves, oldMoverMoves);
#endif
#if defined(DETECT) || defined(REACH)
BUFFER(float, MoverRestitutionSplits, moverRestitutionSplits);
#endif
#ifdef DETECT
BUFFER(uint, LastCollision, lastCollision);
#endif
READ_BUFFER(Counters, CountersBlock, counters);

/// The change of a body's velocity field, for impulses that sum to p and p r^T in its own axes.
Field velocityChange(uint body, Field impulse)
{
    InverseInertia inertia = fetchInverseInertia(body);
    mat3 axes = matrixFromQuaternion(fetchRotation(body));
    mat3 a = impulse.f * transpose(axes);   // sum of p (R r)^T
    vec3 torque = vec3(a[1].z - a[2].y, a[2].x - a[0].z, a[0].y - a[1].x);
    vec3 spin = axes * (symmetricMatrix(inertia.diagonal, inertia.offDiagonal) * (torque * axes));
    return Field(inertia.inverseMass * impulse.t,
                 mat3(cross(spin, axes[0]), cross(spin, axes[1]), cross(spin, axes[2])));
}

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    Mover mover = fetchMover(m);
#if defined(DETECT)
    float splits = responds(m) ? contactSum(mover, counters[0].listParity).acting : 0.0;
    moverRestitutionSplits[m] = splits;
    if (splits > 0.0) lastCollision[0] = counters[0].substep;
#elif defined(REACH)
    if (responds(m) && moverRestitutionSplits[m] == 0.0 && contactSum(mover, counters[0].listParity).acting > 0.0)
        moverRestitutionSplits[m] = REACHED;
#else
    Field v = fetchField(lastMoverVelocities, m);
    if (responds(m)) {
        Sum sum = contactSum(mover, counters[0].listParity);
        Field change = Field(mover.inverseMass * sum.impulse.t, mat3(0));
        if (m < sim.bodyCount) change = velocityChange(m, sum.impulse);
        v = Field(v.t + change.t, v.f + change.f);
        STORE_FIELD(moverVelocities, m, v)
#ifdef BEGIN
        vec4 shift = vec4(sim.substepTime * change.t, 0);
        nextCentres[m] += shift;
        oldMoverMoves[fieldStart(m)] += shift;
#endif
    }
#ifdef BEGIN
    STORE_FIELD(moverSolvedVelocities, m, v)
#endif
#endif
}
