// Boxes of particles are boxes to what touches them: beside a particle in whose direction its lattice goes on, another
// is as far from the body as from the line or the plane through the lattice's particles, so that nothing is caught by
// their bumps. Which axes of its body those are is found with the pair, three bits for each side; they stand above
// the shares of inverse masses.
#include "sim/common/one_sided.glsl"

#define FRACTION_LEVELS 8191.0          // 13 bits

/// The axes along which a lattice goes on from a particle towards another that is beside it. Of what is further off
/// another particle of the lattice is nearer: with all within a diameter, contacts share what one should carry.
/// @param ends of the lattice at the particle, bits 2 k and 2 k + 1: towards - and + along axis k.
/// @param towards the other, in the body's frame [m].
uint hiddenAxes(uint ends, vec3 towards)
{
    uvec3 end = uvec3(ends) >> (uvec3(0, 2, 4) + uvec3(greaterThan(towards, vec3(0)))) & 1u;
    uvec3 hidden = (1u - end) * uvec3(lessThan(abs(towards), vec3(BESIDE * sim.diameter)));
    return hidden.x | hidden.y << 1 | hidden.z << 2;
}

/// A vector without its parts along hidden axes of a body so turned.
vec3 withoutAxes(vec3 v, vec4 rotation, uint hidden)
{
    vec3 shown = vec3(1u - (uvec3(hidden) >> uvec3(0, 1, 2) & 1u));
    return rotate(rotation, shown * rotate(conjugate(rotation), v));
}

/// From the second side of a pair to the first, at `apart` from it: by the face or edge of whichever is nearer.
vec3 flatApart(vec3 apart, vec4 turnA, vec4 turnB, uint hidden)
{
    vec3 a = withoutAxes(apart, turnA, hidden & 7u), b = withoutAxes(apart, turnB, hidden >> 3);
    vec3 nearest = dot(a, a) < dot(b, b) ? a : b;
    float least = LEAST_FLAT * sim.diameter;
    return dot(nearest, nearest) > least * least ? nearest : apart;
}

/// Which way the sides of a pair part.
struct Parting {
    vec3 normal;   // towards the first
    float far;     // how far they are apart along it [m]
    bool sided;    // by the way out of a body
    bool keeps;    // the normal stays while they move, for a way out or a face; else it turns with the two
};

Parting partingOf(vec3 apart, Way way, vec4 turnA, vec4 turnB, uint hidden)
{
    float far = length(apart);
    vec4 sided = sidedNormal(apart, far, way);
    if (sided.w > 0.0) return Parting(sided.xyz, far, true, true);
    if (hidden != 0u) apart = flatApart(apart, turnA, turnB, hidden);
    far = length(apart);
    return Parting(contactNormal(apart, far, true), far, false, hidden != 0u);
}

uint packFractions(vec2 shares, uint hidden)
{
    uvec2 levels = uvec2(shares * FRACTION_LEVELS + 0.5);
    return levels.x | levels.y << 13 | hidden << 26;
}

vec2 unpackFractions(uint bits) { return vec2(bits & 0x1fffu, bits >> 13 & 0x1fffu) / FRACTION_LEVELS; }

uint unpackHidden(uint bits) { return bits >> 26; }
