// One thread a strand: one Newton step of its XPBD distances, all at once (Macklin et al. 2016, eq. 17), with the turning
// of the links that are under tension (the second derivatives, Tournier et al. 2015), without which a light rope under a
// heavy load shakes itself apart. From the end to the start each node and its link are eliminated, which leaves the one
// before it with a mass matrix; then moves and multipliers follow from the start to the end. FIRST_ITERATION: of a substep, where
// the tension that the last one ended with may tear.
#include "sim/common/kernel.glsl"
#include "sim/rope/distance_nodes.glsl"

layout(local_size_x = DISTANCE_GROUP_SIZE) in;
layout(location = 0) uniform uvec2 range;          // the first strand and the end
uniform usamplerBuffer distanceRows;                    // first node, last node, assembly
uniform usamplerBuffer assemblyState;              // last substep with a contact, order of this one
BUFFER(vec4, MoverMoves, moved);
BUFFER(vec4, ParticleImpulses, particleImpulses);
BUFFER(vec4, DistanceStates, distanceStates);          // multiplier [kg m], tension [N], 1 if torn, D; between: q for tension
BUFFER(vec4, DistanceFactors, distanceFactors);        // four a link: n, k; rows of B with r

/// Keep the matrix regular, the larger at a fixed end: where a taut strand is held at both.
const float REGULAR = 1e-5, REGULAR_END = 1e-3;
/// What turning may hold back, over the mass of its nodes: more would be lost to rounding.
const float MOST_TURNING = 30.0;

void push(uint node, vec3 impulse)
{
    uvec4 info = texelFetch(distanceNodes, int(node));
    float share = uintBitsToFloat(info.w);
    if (share == 0.0) return;
    particleImpulses[info.y].xyz += impulse;
    if (info.x >= sim.bodyCount) moved[info.x].xyz += share * impulse;
}

/// Eliminates from the end on. Of the node b of a link: A dx = r + f; with its link B = (A + k P)^-1, P = 1 - n n^T.
/// @returns the move of the first node.
vec3 eliminate(uvec4 strand, float squaredTime)
{
    DistanceNode b = fetchNode(strand.y);
    mat3 mass = massOf(b);
    vec3 r = vec3(0);
    for (uint k = strand.y; k-- > strand.x;) {
        DistanceNode a = fetchNode(k);
        vec4 link = texelFetch(distanceLinks, int(k)), state = distanceStates[k];
        vec3 apart = between(a, b);
        float far = length(apart);
        vec3 n = far > 0.0 ? apart / far : vec3(0, 1, 0);
#ifdef FIRST_ITERATION
        if (state.y > link.z || far > link.w) state.z = 1.0;
        state.x = 0.0;
#endif
        float compliance = link.y / squaredTime, both = dot(n, response(a, n)) + dot(n, response(b, n));
        float turning = min(max(state.y, 0.0) * squaredTime / max(far, 1e-9), MOST_TURNING / max(both, 1e-20));
        mat3 across = mat3(turning) - turning * outerProduct(n, n);
        mat3 inverseB = b.share == 0.0 ? mat3(0) : inverse(mass + across);
        vec3 u = n - across * (inverseB * n), held = inverseB * r;
        float d = dot(n, inverseB * n) + compliance + (b.share == 0.0 ? REGULAR_END : REGULAR) * both;
        float q = link.x - far - compliance * state.x - dot(n, held);
        bool none = state.z != 0.0 || d == 0.0;
        distanceFactors[4u * k] = vec4(n, none ? 0.0 : turning);
        for (int row = 0; row < 3; ++row) distanceFactors[4u * k + 1u + uint(row)] = vec4(inverseB[row], r[row]);
        distanceStates[k] = vec4(state.x, q, state.z, none ? 0.0 : d);
        mass = massOf(a);
        if (!none) mass += across - across * inverseB * across + outerProduct(u, u) / d;
        r = none ? vec3(0) : across * held - u * (q / d);
        b = a;
    }
    return b.share == 0.0 ? vec3(0) : inverse(mass) * r;
}

void main()
{
    uint s = range.x + gl_GlobalInvocationID.x;
    if (s >= range.y) return;
    uvec4 strand = texelFetch(distanceRows, int(s));
    // BDF2 takes 4/9 of h^2 for an acceleration.
    bool second = texelFetch(assemblyState, int(strand.z)).y == 2u;
    float squaredTime = (second ? 4.0 / 9.0 : 1.0) * sim.substepTime * sim.substepTime;
    vec3 move = eliminate(strand, squaredTime), before = vec3(0);
    for (uint k = strand.x; k < strand.y; ++k) {
        vec4 f = distanceFactors[4u * k], state = distanceStates[k];
        mat3 inverseB;
        vec3 r;
        for (int row = 0; row < 3; ++row) {
            vec4 values = distanceFactors[4u * k + 1u + uint(row)];
            inverseB[row] = values.xyz;
            r[row] = values.w;
        }
        mat3 across = mat3(f.w) - f.w * outerProduct(f.xyz, f.xyz);
        vec3 u = f.xyz - across * (inverseB * f.xyz);
        float change = state.w > 0.0 ? (state.y + dot(u, move)) / state.w : 0.0;
        vec3 next = inverseB * (r + change * f.xyz + across * move);
        vec3 pull = change * f.xyz - across * (next - move);
        float multiplier = state.x + change;
        distanceStates[k] = vec4(multiplier, -multiplier / squaredTime, state.z, 0.0);
        push(k, before - pull);
        before = pull;
        move = next;
    }
    push(strand.y, before);
}
