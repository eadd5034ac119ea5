// One thread a slot: the density of its fluid particle and the multiplier of its constraint (Macklin and Mueller 2013,
// eqs. 1, 8-11): C = rho / rho0 - 1, lambda = -C / (sum w |grad C|^2 + epsilon). Solids and walls count by the share of
// the kernel that they cover. Fluids are not held together: C >= 0.
#include "shared/kernel.glsl"
#include "shared/fluid_slots.glsl"
#include "shared/fluid.glsl"
#include "shared/fluid_colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotPlaces;
uniform samplerBuffer masses;            // inverse mass
BUFFER(vec4, SlotPressures, slotPressures);   // place, lambda [kg m2]
BUFFER(vec4, SlotWalls, slotWalls);           // gradient of C by what walls cover [1/m]; w: density over rest density
BUFFER(vec4, SlotSolids, slotSolids);         // the same of solids; w: one over their weights

/// Of the solid particles nearby as one plane: the weighted means of their distances and directions.
vec4 solidPlane(uint k, uint count, vec3 x, out float weights)
{
    vec4 plane = vec4(0);
    weights = 0.0;
    for (uint n = 0u; n < count; ++n) {
        vec3 r = x - texelFetch(slotPlaces, int(solidNeighbour(k, n))).xyz;
        float far = length(r), w = solidWeight(far);
        plane += w * vec4(r / max(far, 1e-9), far - SOLID_RADIUS * step.diameter);
        weights += w;
    }
    return vec4(normalize(plane.xyz + vec3(0, 1e-20, 0)), plane.w / max(weights, 1e-20));
}

/// Sums over neighbours: share of the kernel, squares of its slopes, and its gradient.
struct Sums {
    float share, squares;
    vec3 gradient;
};

void add(inout Sums sums, vec3 x, uint slot)
{
    vec3 r = x - texelFetch(slotPlaces, int(slot)).xyz;
    float squared = dot(r, r), q = min(sqrt(squared) / step.fluidReach, 1.0), slope = fluidSlope(q);
    sums.share += fluidShare(q);
    sums.squares += slope * slope * squared;
    sums.gradient += slope * r;
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = texelFetch(slotParticles, int(k)).x;
    uvec2 counts = isFluid(i) ? texelFetch(slotCounts, int(k)).xy : uvec2(0);
    vec3 x = texelFetch(slotPlaces, int(k)).xyz, walls = vec3(0), solids = vec3(0);
    // The slot itself stands in its list where that is no multiple of four: taken away again.
    Sums sums = Sums(fluidShare(0.0) * (1.0 - float(-counts.x & 3u)), 0.0, vec3(0));
    for (uint n = 0u; n < counts.x; n += 4u) {
        uvec4 slots = fourNeighbours(k, n);
        add(sums, x, slots.x);
        add(sums, x, slots.y);
        add(sums, x, slots.z);
        add(sums, x, slots.w);
    }
    float share = sums.share;
    float weights;
    vec4 plane = solidPlane(k, counts.y, x, weights);
    vec2 covered = weights > 0.0 ? wallShare(plane.w) : vec2(0);
    share += covered.x;
    solids = covered.y * plane.xyz;
    for (NearColliders near = nearColliders(k); nextCollider(near);) {
        vec4 wall = colliderDistance(near.index, x);
        vec2 hidden = wallShare(wall.w);
        share += hidden.x;
        walls += hidden.y * wall.xyz;
    }
    vec3 own = sums.gradient + walls + solids;
    // All constraints around are met at once: more than this and they overshoot.
    float lambda = -FLUID_RELAXATION * max(share - 1.0, 0.0) / (dot(own, own) + sums.squares + step.fluidSoftness);
    slotPressures[k] = vec4(x, lambda / max(texelFetch(masses, int(i)).x, 1e-20));
    slotWalls[k] = vec4(walls, share);
    slotSolids[k] = vec4(solids, weights > 0.0 ? 1.0 / weights : 0.0);
}
