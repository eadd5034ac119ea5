// Balls and capsules of particles are smooth: contacts meet the surface about their centre line, not the balls of their
// particles. A particle of such a body only says where it is touched. ROUNDS: of a world that has any.

uniform samplerBuffer bodyRounds;
uniform usamplerBuffer latticeEnds;

struct RoundBody {
    vec3 low, high;     // ends of its centre line, in the body's axes [m]
    float radius;       // [m]
    float rolling;      // rolling friction
};

RoundBody fetchRound(uint body)
{
    vec4 low = texelFetch(bodyRounds, int(2u * body)), high = texelFetch(bodyRounds, int(2u * body + 1u));
    return RoundBody(low.xyz, high.xyz, low.w, high.w);
}

/// Whether a particle belongs to a ball or a capsule.
bool isRound(uint particle)
{
#ifdef ROUNDS
    return (texelFetch(latticeEnds, int(particle)).x & IN_ROUND) != 0u;
#else
    return false;
#endif
}

/// The point of a centre line that is nearest to p, in the body's axes.
vec3 onLine(RoundBody body, vec3 p)
{
    vec3 along = body.high - body.low;
    float t = dot(p - body.low, along) / max(dot(along, along), 1e-20);
    return body.low + clamp(t, 0.0, 1.0) * along;
}
