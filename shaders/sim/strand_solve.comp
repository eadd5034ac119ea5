// One thread a strand: one Newton step of its XPBD distances, all at once. Neighbouring distances meet in the particle
// between them, so that (J W J^T + alpha / h^2) d = -(C + alpha / h^2 lambda) (Macklin et al. 2016, eq. 17) is
// tridiagonal: a forward sweep factors it (L D L^T), a backward one finds the multipliers' changes d and moves the
// particles. FIRST: of a substep, where the tension that the last one ended with may tear.
#include "shared/kernel.glsl"
#include "shared/strands.glsl"

layout(local_size_x = STRAND_GROUP_SIZE) in;
layout(location = 0) uniform uvec2 range;          // the first strand and the end
uniform usamplerBuffer strands;                    // first node, last node, assembly
uniform usamplerBuffer assemblyState;              // last substep with a contact, order of this one
BUFFER(vec4, MoverMoves, moved);
BUFFER(vec4, ParticleImpulses, particleImpulses);
BUFFER(vec4, StrandStates, strandStates);          // multiplier [kg m], tension [N], 1 if torn, D^-1 L^-1 of the right
BUFFER(vec4, StrandFactors, strandFactors);        // direction, L

/// Keeps the matrix regular where a taut strand is held at both ends.
const float REGULAR = 1e-5;

void push(uint node, vec3 impulse)
{
    uvec4 info = texelFetch(strandNodes, int(node));
    float share = uintBitsToFloat(info.w);
    if (share == 0.0) return;
    particleImpulses[info.y].xyz += impulse;
    if (info.x >= step.bodyCount) moved[info.x].xyz += share * impulse;
}

void factor(uvec4 strand, float squaredTime)
{
    StrandNode a = fetchNode(strand.x);
    vec3 before = vec3(0);
    float pivot = 1.0, value = 0.0;
    for (uint k = strand.x; k < strand.y; ++k) {
        StrandNode b = fetchNode(k + 1u);
        vec4 link = texelFetch(strandLinks, int(k)), state = strandStates[k];
        vec3 apart = between(a, b);
        float far = length(apart);
        vec3 n = far > 0.0 ? apart / far : vec3(0, 1, 0);
#ifdef FIRST
        if (state.y > link.z || far > link.w) state.z = 1.0;
        state.x = 0.0;
#endif
        bool torn = state.z != 0.0;
        float compliance = link.y / squaredTime;
        vec3 moves = response(a, n);
        float diagonal = (dot(n, moves) + dot(n, response(b, n))) * (1.0 + REGULAR) + compliance;
        float lower = torn ? 0.0 : -dot(before, moves) / pivot;
        value = torn ? 0.0 : link.x - far - compliance * state.x - lower * value;
        pivot = torn || diagonal == 0.0 ? 1.0 : diagonal - lower * lower * pivot;
        strandFactors[k] = vec4(n, lower);
        strandStates[k] = vec4(state.xyz, value / pivot);
        before = torn ? vec3(0) : n;
        a = b;
    }
}

void main()
{
    uint s = range.x + gl_GlobalInvocationID.x;
    if (s >= range.y) return;
    uvec4 strand = texelFetch(strands, int(s));
    // BDF2 takes 4/9 of h^2 for an acceleration.
    bool second = texelFetch(assemblyState, int(strand.z)).y == 2u;
    float squaredTime = (second ? 4.0 / 9.0 : 1.0) * step.substepTime * step.substepTime;
    factor(strand, squaredTime);

    vec3 later = vec3(0);
    float carried = 0.0;
    for (uint k = strand.y; k > strand.x; --k) {
        vec4 f = strandFactors[k - 1u], state = strandStates[k - 1u];
        float change = state.w - carried;
        float multiplier = state.x + change;
        strandStates[k - 1u] = vec4(multiplier, -multiplier / squaredTime, state.z, 0.0);
        push(k, change * f.xyz - later);
        later = change * f.xyz;
        carried = f.w * change;
    }
    push(strand.x, -later);
}
