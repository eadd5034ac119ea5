// One thread a slot: the density of its fluid particle and the multiplier of its constraint (Macklin and Mueller 2013,
// eqs. 1, 8-11): C = rho / rho0 - 1, lambda = -C / (sum w |grad C|^2 + epsilon). Solids and walls count by the share of
// the kernel that they cover. Fluids are not held together: C >= 0.
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/fluid/fluid_colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotPositions;
uniform samplerBuffer masses;            // inverse mass
BUFFER(vec4, SlotPressures, slotPressures);   // place, lambda [kg m2]
BUFFER(vec4, SlotWalls, slotWalls);           // gradient of C by what walls cover [1/m]; w: density over rest density
BUFFER(vec4, SlotSolids, slotSolids);         // the same of solids; w: one over their weights

/// What the solid particles nearby cover, w, and its slope, across the surface that they form together: along it their
/// bumps would hold the fluid. In a gap or a hole they form none, and a slope that is not the share's own would shoot
/// out what came in slowly. @param weights  Sum of their weights. @param squares  Of the slopes of each.
vec4 solidCover(uint k, uint count, vec3 x, out float weights, out float squares)
{
    vec3 slope = vec3(0), way = vec3(0, 1e-12, 0);
    float share = 0.0;
    weights = squares = 0.0;
    for (uint n = 0u; n < count; ++n) {
        vec3 r = x - texelFetch(slotPositions, int(solidNeighbour(k, n))).xyz;
        float far = length(r), weight = solidWeight(far);
        vec2 covered = solidFraction(far);
        share += covered.x;
        slope += covered.y * r;
        squares += covered.y * covered.y * far * far;
        weights += weight;
        way += weight / max(far, 1e-9) * r;
    }
    vec3 across = normalize(way), along = slope - dot(slope, across) * across;
    float oneSided = smoothstep(0.3, 0.6, length(way) / max(weights, 1e-20));
    return vec4(slope - oneSided * along, share);
}

/// Sums over neighbours, in units of the kernel's height and steepness: share of the kernel, squares of its slopes, and
/// its gradient.
struct Sums {
    float share, squares;
    vec3 gradient;
};

void add(inout Sums sums, vec3 x, float inverseReach, uint slot)
{
    vec3 r = x - texelFetch(slotPositions, int(slot)).xyz;
    float squared = dot(r, r), a = 1.0 - min(sqrt(squared) * inverseReach, 1.0), cube = a * a * a;
    sums.share += fluidShape(a);
    sums.squares += cube * cube * squared;
    sums.gradient += cube * r;
}

Sums sumsOver(uint k, uint count, vec3 x)
{
    // The slot itself stands in its list where that is no multiple of four: taken away again.
    Sums sums = Sums(1.0 - float(-count & 3u), 0.0, vec3(0));
    float inverseReach = 1.0 / sim.fluidReach, steepness = fluidSteepness();
    for (uint n = 0u, texel = neighbourTexel(k, 0u); n < count; n += 4u, texel += NEIGHBOUR_BLOCK) {
        uvec4 slots = neighboursAt(texel);
        add(sums, x, inverseReach, slots.x);
        add(sums, x, inverseReach, slots.y);
        add(sums, x, inverseReach, slots.z);
        add(sums, x, inverseReach, slots.w);
    }
    return Sums(sim.fluidVolume * sums.share, steepness * steepness * sums.squares, steepness * sums.gradient);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = texelFetch(slotParticles, int(k)).x;
    uvec2 counts = isFluid(i) ? texelFetch(slotCounts, int(k)).xy : uvec2(0);
    vec3 x = texelFetch(slotPositions, int(k)).xyz;
    Sums sums = sumsOver(k, counts.x, x);
    float weights, slopes;
    vec4 solids = solidCover(k, counts.y, x, weights, slopes), walls = vec4(0);
    for (NearColliders near = nearColliders(k); nextCollider(near);) {
        vec4 wall = colliderDistance(near.index, x);
        walls = addWall(walls, wall.xyz, wallFraction(wall.w));
    }
    float share = sums.share + walls.w + solids.w;
    vec3 own = sums.gradient + walls.xyz + solids.xyz;
    // All constraints around are met at once: more than this and they overshoot.
    float tooMuch = clamp(share - 1.0, 0.0, MOST_FLUID_ERROR);
    // Where the slopes of solids cancel, as between two of them, no way leads out: pushing harder does not help.
    float opposed = max(slopes - dot(solids.xyz, solids.xyz), 0.0);
    float lambda = -FLUID_RELAXATION * tooMuch / (dot(own, own) + opposed + sums.squares + sim.fluidSoftness);
    slotPressures[k] = vec4(x, lambda / max(texelFetch(masses, int(i)).x, 1e-20));
    slotWalls[k] = vec4(walls.xyz, share);
    slotSolids[k] = vec4(solids.xyz, weights > 0.0 ? 1.0 / weights : 0.0);
}
