// One thread a mover, after pressures: they move its particles as they move all of it. Taken by themselves, those at
// the bottom of a body would be pushed in and pull the fluid after them, which takes buoyancy away.
#include "sim/common/kernel.glsl"
#include "math/symmetric.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/viscous/viscous_slots.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer particleImpulses;  // by rank
BUFFER(vec4, SlotGoals, newSlotGoals);

/// How impulses change a mover's motion, over the mass: `turn` is in its axes.
struct Push {
    vec3 shift;   // [m/s]
    vec3 turn;    // [1/s]
};

vec3 impulseAt(uint rank)
{
    return texelFetch(particleImpulses, int(rank)).xyz / sim.substepTime;
}

Push pushOf(uint m, Mover mover, vec4 toAxes)
{
    Push sum = Push(vec3(0), vec3(0));
    for (uint rank = mover.firstRank; rank < mover.firstRank + mover.rankCount; ++rank) {
        vec3 p = impulseAt(rank);
        sum.shift += p;
        sum.turn += cross(fetchArm(fetchRankedParticle(rank)).r, rotate(toAxes, p));
    }
    if (m >= sim.bodyCount) return Push(mover.inverseMass * sum.shift, vec3(0));
    InverseInertia inertia = fetchInverseInertia(m);
    return Push(mover.inverseMass * sum.shift, symmetricMatrix(inertia.diagonal, inertia.offDiagonal) * sum.turn);
}

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount || !responds(m)) return;
    Mover mover = fetchMover(m);
    vec4 rotation = fetchRotation(m);
    Push push = pushOf(m, mover, conjugate(rotation));
    for (uint rank = mover.firstRank; rank < mover.firstRank + mover.rankCount; ++rank) {
        uint i = fetchRankedParticle(rank);
        newSlotGoals[fetchParticleSlot(i)].xyz += push.shift + rotate(rotation, cross(push.turn, fetchArm(i).r));
    }
}
