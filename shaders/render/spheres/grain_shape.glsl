// How grains of sand differ: sizes, tints, proportions and cuts by their number, no two alike.
uniform usamplerBuffer grainParticles;      // a bit each

bool isGrain(uint particle)
{
    return (texelFetch(grainParticles, int(particle / 32u)).x >> particle % 32u & 1u) != 0u;
}

/// 0 ... 1 by a hash.
float grainPart(uint number, uint salt)
{
    uint bits = (32u * number + salt) * 2654435761u + 374761393u;
    bits = (bits ^ bits >> 15) * 2246822519u;
    bits = (bits ^ bits >> 13) * 3266489917u;
    return float((bits ^ bits >> 16) >> 8) / 16777216.0;
}

vec4 grainParts(uint number, uint salt)
{
    return vec4(grainPart(number, salt), grainPart(number, salt + 1u), grainPart(number, salt + 2u),
                grainPart(number, salt + 3u));
}

/// Its longest radius over that of the particle.
float grainSize(uint number)
{
    return mix(0.95, 1.25, grainPart(number, 0u));
}

/// Factors of the roots of its colour.
vec3 grainTint(uint number)
{
    float bright = mix(0.80, 1.06, grainPart(number, 1u)), warm = mix(-0.04, 0.04, grainPart(number, 2u));
    return bright * vec3(1.0 + warm, 1.0, 1.0 - 2.0 * warm);
}

/// Its three radii over the longest.
vec3 grainStretch(uint number)
{
    return vec3(1.0, mix(0.78, 1.0, grainPart(number, 3u)), mix(0.64, 0.88, grainPart(number, 4u)));
}

/// A rotation, all alike (Shoemake 1992).
vec4 grainTurn(uint number)
{
    float u = grainPart(number, 5u), a = 6.2831853 * grainPart(number, 6u), b = 6.2831853 * grainPart(number, 7u);
    return vec4(sqrt(1.0 - u) * vec2(sin(a), cos(a)), sqrt(u) * vec2(sin(b), cos(b)));
}
