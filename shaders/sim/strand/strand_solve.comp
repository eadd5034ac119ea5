// One thread a strand: one Newton step of its XPBD distances, all at once (Macklin et al. 2016, eq. 17), including the
// turning of links under tension (the second derivatives, Tournier et al. 2015), without which a light rope under a
// heavy load shakes itself apart. From the end to the start each node and its link are eliminated, which adds a mass
// matrix to the node before; then moves and multipliers follow from the start to the end. FIRST_ITERATION: of a
// substep, in which the final tension of the last one may tear links.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/strand/distance_response.glsl"
#include "sim/strand/distance_states.glsl"
#include "sim/strand/strand_nodes.glsl"

layout(local_size_x = DISTANCE_GROUP_SIZE) in;
layout(location = 0) uniform uvec2 range;          // the first strand and the end
BUFFER(vec4, DistanceStates, distanceStates);
BUFFER(REAL4, DistanceFactors, distanceFactors);
#ifdef LETS_GO
uniform usamplerBuffer strandReleases;   // the first substeps without the first and the last link
READ_BUFFER(Counters, CountersBlock, counters);

/// Whether the time of a link at a strand's end is over.
bool isLetGo(uint index, Strand strand, uint k)
{
    uvec2 release = texelFetch(strandReleases, int(index)).xy;
    uint now = counters[0].substep - 1u;
    return (k == strand.first && now >= release.x) || (k + 1u == strand.last && now >= release.y);
}
#endif

/// Eliminates from the end on. For the node b of a link: A dx = r + f; with its link B = (A + k P)^-1, P = 1 - n n^T.
/// @returns the move of the first node.
REAL3 eliminate(uint index, Strand strand, float squaredTime)
{
    DistanceNode b = fetchNode(strand.last);
    REAL3X3 mass;
    REAL3 r;
    ownOf(b, strand.last, mass, r);
    for (uint k = strand.last; k-- > strand.first;) {
        DistanceNode a = fetchNode(k);
        DistanceLink link = fetchDistanceLink(k);
        DistanceState state = distanceState(distanceStates[k]);
        REAL3 apart = REAL3(between(a, b));
        REAL linkLength = length(apart);
        REAL3 n = linkLength > 0.0 ? apart / linkLength : REAL3(0, 1, 0);
#ifdef FIRST_ITERATION
        if (state.tension > link.tearForce || linkLength > link.tearLength) state.torn = 1.0;
        state.multiplier = 0.0;
#ifdef LETS_GO
        if (isLetGo(index, strand, k)) state.torn = 1.0;
#endif
#endif
        bool held = b.info.inverseMass == 0.0;
        REAL compliance = link.compliance / squaredTime;
        REAL both = dot(n, REAL3(response(a, vec3(n)))) + dot(n, REAL3(response(b, vec3(n))));
        REAL turning = min(max(state.tension, 0.0) * squaredTime / max(linkLength, REAL(1e-9)),
                           MOST_TURNING / max(both, REAL(1e-20)));
        REAL3X3 across = turningMass(n, turning);
        REAL3X3 inverseB = held ? REAL3X3(0) : inverse(mass + across);
        REAL3 u = n - across * (inverseB * n), asked = inverseB * r;
        REAL d = dot(n, inverseB * n) + compliance + (held ? REGULAR_END : REGULAR) * both;
        REAL q = link.restLength - linkLength - compliance * state.multiplier - dot(n, asked);
        bool none = state.torn != 0.0 || d == 0.0;
        DistanceFactor factor = DistanceFactor(n, none ? REAL(0) : turning, inverseB, r);
        STORE_DISTANCE_FACTOR(distanceFactors, k, factor);
        distanceStates[k] = pack(EliminatedLink(state.multiplier, float(q), state.torn, none ? 0.0 : float(d)));
        REAL3 own;
        ownOf(a, k, mass, own);
        REAL3 moved = movedResidual(n, inverseB, across);
        if (!none) mass += across - across * inverseB * across + outerProduct(u, moved) / d;
        r = none ? own : own + across * asked - u * (q / d);
        b = a;
    }
    return b.info.inverseMass == 0.0 ? REAL3(0) : inverse(mass) * r;
}

void main()
{
    uint index = range.x + gl_GlobalInvocationID.x;
    if (index >= range.y) return;
    Strand strand = fetchStrand(index);
    if (rests(strand)) return;
    float squaredTime = accelerationFactor(fetchAssembly(strand.assembly)) * sim.substepTime * sim.substepTime;
    REAL3 move = eliminate(index, strand, squaredTime), before = REAL3(0);
    for (uint k = strand.first; k < strand.last; ++k) {
        DistanceFactor f;
        LOAD_DISTANCE_FACTOR(distanceFactors, k, f)
        EliminatedLink link = eliminatedLink(distanceStates[k]);
        REAL3X3 across = turningMass(f.n, f.turning);
        REAL3 u = movedResidual(f.n, f.inverse, across);
        REAL change = link.divisor > 0.0 ? (link.residual + dot(u, move)) / link.divisor : REAL(0);
        REAL3 next = f.inverse * (f.r + change * f.n + across * move);
        REAL3 pull = change * f.n - across * (next - move);
        float multiplier = link.multiplier + float(change);
        distanceStates[k] = pack(DistanceState(multiplier, -multiplier / squaredTime, link.torn));
        moveNode(k, vec3(before - pull), vec3(move));
        before = pull;
        move = next;
    }
    moveNode(strand.last, vec3(before), vec3(move));
}
