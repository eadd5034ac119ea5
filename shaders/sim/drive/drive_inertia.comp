// One thread a puppet: the inertia that each of its drives and pins moves, at the start of the substep. The stiffness
// of a spring follows from it and the spring's frequency, so that a finger and a thigh feel alike, stretched or bent.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "shared/animation_types.h"
#include "shared/drive_types.h"
#include "sim/drive/composite.glsl"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(Puppet, Puppets, puppets);
READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
uniform usamplerBuffer puppetOrder;      // of animated bodies, parents before what hangs on them; 1: pinned
BUFFER(vec4, Composites, composites);    // of each body and all that hangs on it
BUFFER(vec4, Carried, carried);          // the same, without what is pinned itself
BUFFER(vec4, DriveInertias, driveInertias);

Composite ownOf(uint body)
{
    mat3 axes = matrixFromQuaternion(fetchRotation(body)), moments = axes * fetchMoments(body) * transpose(axes);
    float mass = moverMass(body);
    // A row of particles has no inertia about itself, which would make it singular.
    float least = 1e-5 * mass * sim.diameter * sim.diameter;
    return Composite(mass, fetchCentre(body), mat3(traceOf(moments) + least) - moments);
}

/// Adds a finished body to its parent.
void collect(uint k, bool pinned)
{
    uint parent = animatedBodies[k].parent;
    if (parent == NONE) return;
    Composite all = COMPOSITE_FROM(composites, k), above = COMPOSITE_FROM(composites, parent);
    Composite more = joined(above, all, 1.0);
    STORE_COMPOSITE(composites, parent, more)
    if (pinned) return;
    all = COMPOSITE_FROM(carried, k);
    above = COMPOSITE_FROM(carried, parent);
    more = joined(above, all, 1.0);
    STORE_COMPOSITE(carried, parent, more)
}

void storeInertia(uint entry, mat3 inertia)
{
    driveInertias[2u * entry].xyz = diagonalOf(inertia);
    driveInertias[2u * entry + 1u].xyz = offDiagonalOf(inertia);
}

/// The inertia that a body's drive turns, about the joint on which the body hangs.
mat3 drivenInertia(AnimatedBody at, Composite below, Composite all, bool held)
{
    vec3 anchor = fetchCentre(at.mover) + rotate(fetchRotation(at.mover), at.anchor.xyz - at.centre.xyz);
    Side parent = Side(0.0, mat3(0), mat3(0));
    if (!held) parent = sideOf(joined(all, below, -1.0), anchor);
    return turnedInertia(sideOf(below, anchor), parent);
}

void main()
{
    uint p = gl_GlobalInvocationID.x;
    if (p >= sim.puppetCount) return;
    Puppet puppet = puppets[p];
    uint first = puppet.firstBody, end = first + puppet.bodyCount;
    for (uint k = first; k < end; ++k) {
        Composite own = ownOf(animatedBodies[k].mover);
        STORE_COMPOSITE(composites, k, own)
        STORE_COMPOSITE(carried, k, own)
    }
    for (uint i = end; i-- > first;) {
        uvec2 order = texelFetch(puppetOrder, int(i)).xy;
        collect(order.x, order.y == 1u);
    }
    uint root = texelFetch(puppetOrder, int(first)).x;
    Composite all = COMPOSITE_FROM(composites, root);
    bool held = puppet.isHeld == 1u || !responds(animatedBodies[root].mover);
    for (uint k = first; k < end; ++k) {
        AnimatedBody at = animatedBodies[k];
        Composite below = COMPOSITE_FROM(composites, k), holds = COMPOSITE_FROM(carried, k);
        if (at.parent != NONE) storeInertia(2u * k, drivenInertia(at, below, all, held));
        storeInertia(2u * k + 1u, holds.inertia + atArm(holds.mass, holds.centre - fetchCentre(at.mover)));
        driveInertias[4u * k + 2u].w = holds.mass;
    }
}
