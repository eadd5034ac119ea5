// Balls that are stretched or flattened along one axis, in 32 bits.
#include "math/octahedron.glsl"

struct Spheroid {
    vec3 axis;      // unit
    float along;    // half lengths along the axis and across it, over a radius
    float across;
};

// Half lengths are powers of two from -STRETCH to STRETCH, in steps of a hundredth. No word is 0, a ball, or
// INNER, a ball that others hide from all sides.
const float STRETCH = 0.9, SPHEROID_STEPS = 63.0;
const uint INNER = 1u;

uint packSpheroid(Spheroid s)
{
    uvec2 axis = uvec2(round((0.5 + 0.5 * toSquare(s.axis)) * 511.0));
    vec2 lengths = clamp(log2(vec2(s.along, s.across)) / STRETCH, vec2(-1.0), vec2(1.0));
    uvec2 steps = uvec2(round(64.0 + SPHEROID_STEPS * lengths));
    return axis.x | axis.y << 9 | steps.x << 18 | steps.y << 25;
}

Spheroid unpackSpheroid(uint word)
{
    if (word <= INNER) return Spheroid(vec3(0, 1, 0), 1.0, 1.0);
    vec2 axis = vec2(word & 511u, word >> 9 & 511u) / 511.0 * 2.0 - 1.0;
    vec2 steps = vec2(word >> 18 & 127u, word >> 25);
    vec2 lengths = exp2(STRETCH * (steps - 64.0) / SPHEROID_STEPS);
    return Spheroid(fromSquare(axis), lengths.x, lengths.y);
}
