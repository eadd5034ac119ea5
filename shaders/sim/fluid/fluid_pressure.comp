// One thread a slot: moves its fluid particle by the pressures around it (Macklin and Mueller 2013, eq. 12, with masses:
// a pair exchanges the impulse (lambda_i + lambda_j) grad W, so momentum is kept), ends its substep, and predicts where
// it comes to in the next. RELAX: moves it without making it any faster.
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/fluid/fluid_colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotPressures;     // place, lambda
uniform samplerBuffer slotWalls;
uniform samplerBuffer slotSolids;
uniform samplerBuffer slotVelocities;    // when the step began
uniform samplerBuffer masses;            // inverse mass
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(vec4, SlotPositions, slotPositions);
BUFFER(Counters, CountersBlock, counters);

/// Out of the colliders, at least a quarter of the rest distance away from them.
vec3 outside(uint k, vec3 x)
{
    for (NearColliders near = nearColliders(k); nextCollider(near);) {
        vec4 wall = colliderDistance(near.index, x);
        x += max(0.25 * sim.fluidSpacing - wall.w, 0.0) * wall.xyz;
    }
    return x;
}

/// What the particle in another slot gives, in units of the kernel's steepness. s_corr (eq. 13) adds to the multipliers
/// of particles that are too near to each other a share of them, so where nothing is too dense nothing is pushed.
vec3 impulseOf(vec4 own, float inverseReach, uint slot)
{
    vec4 other = texelFetch(slotPressures, int(slot));
    vec3 r = own.xyz - other.xyz;
    float a = 1.0 - min(sqrt(dot(r, r)) * inverseReach, 1.0), crowd = fluidShape(a), crowd2 = crowd * crowd;
    return (own.w + other.w) * (1.0 + FLUID_REPULSION * crowd2 * crowd2) * (a * a * a) * r;
}

#ifdef TENSION
uniform samplerBuffer fluidMaterials;    // smoothing, tension
uniform usamplerBuffer slotMaterials;

/// Surface tension: particles of one fluid attract each other (fluidPull).
vec3 tensionOf(vec4 own, uint material, float tension, uint slot)
{
    vec3 r = own.xyz - texelFetch(slotPressures, int(slot)).xyz;
    float far = length(r), same = texelFetch(slotMaterials, int(slot)).x == material ? 1.0 : 0.0;
    return -same * tension * fluidPull(min(far / sim.fluidReach, 1.0)) / max(far, 1e-9) * r;
}
#endif

/// The speed that the particle may come to, for one that had `before` and would have `now`. Between solids, or one and a
/// wall, whatever pushes it out in one substep would make it as fast as that takes; it keeps what they or it had, and a
/// little more.
float mostSpeed(uint k, vec3 x, float before, float now)
{
    float gain = MOST_SQUEEZE * sim.substepTime, fastest = before;
    if (now <= before + gain) return sim.maxSpeed;
    uint count = texelFetch(slotCounts, int(k)).y;
    bool among = false;
    for (uint n = 0u; n < count; ++n) {
        int solid = int(solidNeighbour(k, n));
        if (distance(x, texelFetch(slotPressures, solid).xyz) >= sim.fluidListReach) continue;
        among = true;
        fastest = max(fastest, length(texelFetch(slotVelocities, solid).xyz));
    }
    return among ? min(fastest + gain, sim.maxSpeed) : sim.maxSpeed;
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = texelFetch(slotParticles, int(k)).x;
    bool fluid = isFluid(i);
    uint count = fluid ? texelFetch(slotCounts, int(k)).x : 0u;
    vec4 own = texelFetch(slotPressures, int(k));
    vec3 pressed = own.w * (texelFetch(slotWalls, int(k)).xyz + texelFetch(slotSolids, int(k)).xyz);
    vec3 others = vec3(0), pulled = vec3(0);
    float inverseReach = 1.0 / sim.fluidReach;
#ifdef TENSION
    uint material = texelFetch(slotMaterials, int(k)).x;
    float tension = texelFetch(fluidMaterials, int(material)).y;
#endif
    for (uint n = 0u, texel = neighbourTexel(k, 0u); n < count; n += 4u, texel += NEIGHBOUR_BLOCK) {
        uvec4 slots = neighboursAt(texel);
        others += impulseOf(own, inverseReach, slots.x);
        others += impulseOf(own, inverseReach, slots.y);
        others += impulseOf(own, inverseReach, slots.z);
        others += impulseOf(own, inverseReach, slots.w);
#ifdef TENSION
        for (int c = 0; c < 4; ++c) pulled += tensionOf(own, material, tension, slots[c]);
#endif
    }
    if (!fluid) return;
    vec3 push = texelFetch(masses, int(i)).x * (pressed + fluidSteepness() * others + pulled);
    vec4 last = velocities[i];
    float held = timeHeld(last);
    push *= held > 0.0 ? 0.0 : min(1.0, 0.25 * sim.fluidReach / max(length(push), 1e-20));
    vec3 before = positions[i].xyz, x = outside(k, own.xyz + push);
#ifdef RELAX
    positions[i].xyz = slotPositions[k].xyz = x;
    return;
#endif
    vec3 v = (x - before) * (sim.damping / sim.substepTime);
    float speed = length(v);
    if (isnan(speed) || isinf(speed)) {
        atomicOr(counters[0].problems, PROBLEM_NAN);
        atomicMax(counters[0].badParticle, i);
    }
    float most = mostSpeed(k, own.xyz, length(last.xyz), speed);
    v *= min(1.0, most / max(speed, 1e-20));
    velocities[i] = vec4(v, max(held - sim.substepTime, 0.0));
    positions[i].xyz = x;
    slotPositions[k].xyz = predictedPosition(x, v);
}
