// One thread a slot: moves its fluid particle by the pressures around it (Macklin and Mueller 2013, eq. 12, with masses:
// a pair exchanges the impulse (lambda_i + lambda_j) grad W, so momentum is kept) and ends its substep.
// SETTLE: moves it without making it any faster.
#include "shared/kernel.glsl"
#include "shared/fluid_slots.glsl"
#include "shared/fluid.glsl"
#include "shared/fluid_colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotPressures;     // place, lambda
uniform samplerBuffer slotWalls;
uniform samplerBuffer slotSolids;
uniform samplerBuffer masses;            // inverse mass
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(Counters, CountersBlock, counters);

/// Out of the colliders, at least a quarter of the rest distance away from them.
vec3 outside(uint k, vec3 x)
{
    for (NearColliders near = nearColliders(k); nextCollider(near);) {
        vec4 wall = colliderDistance(near.index, x);
        x += max(0.25 * step.fluidSpacing - wall.w, 0.0) * wall.xyz;
    }
    return x;
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = texelFetch(slotParticles, int(k)).x;
    bool fluid = isFluid(i);
    uint count = fluid ? texelFetch(slotCounts, int(k)).x : 0u;
    vec4 own = texelFetch(slotPressures, int(k));
    float inverseReach = 1.0 / step.fluidReach;
    vec3 impulse = own.w * (texelFetch(slotWalls, int(k)).xyz + texelFetch(slotSolids, int(k)).xyz);
    for (uint n = 0u; n < count; ++n) {
        vec4 other = texelFetch(slotPressures, int(fluidNeighbour(k, n)));
        vec3 r = own.xyz - other.xyz;
        float q = min(sqrt(dot(r, r)) * inverseReach, 1.0);
        impulse += (own.w + other.w) * fluidSlope(q) * r;
    }
    if (!fluid) return;
    vec3 push = texelFetch(masses, int(i)).x * impulse;
    push *= min(1.0, 0.1 * step.fluidReach / max(length(push), 1e-20));
    vec3 before = positions[i].xyz, x = outside(k, own.xyz + push);
#ifdef SETTLE
    positions[i].xyz = x;
    return;
#endif
    vec3 v = (x - before) * (step.damping / step.substepTime);
    float speed = length(v);
    if (isnan(speed) || isinf(speed)) {
        atomicOr(counters[0].problems, PROBLEM_NAN);
        atomicMax(counters[0].badParticle, i);
    }
    velocities[i] = vec4(v * min(1.0, step.maxSpeed / max(speed, 1e-20)), 0);
    positions[i].xyz = x;
}
