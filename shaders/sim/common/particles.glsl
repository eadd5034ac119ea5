// What never changes about particles, by their index.

uniform usamplerBuffer particleInfo;
uniform usamplerBuffer particleRanks;
uniform usamplerBuffer rankedParticles;  // by rank: the particle
uniform samplerBuffer masses;
uniform samplerBuffer restOffsets;

Particle fetchParticle(uint i)
{
    uvec4 t = texelFetch(particleInfo, int(i));
    return Particle(t.x, t.y, t.z, t.w);
}

ParticleRank fetchRank(uint i)
{
    uvec2 t = texelFetch(particleRanks, int(i)).xy;
    return ParticleRank(t.x, t.y);
}

uint fetchRankedParticle(uint rank)
{
    return texelFetch(rankedParticles, int(rank)).x;
}

/// Mass and surface properties.
struct ParticleMass {
    float inverseMass;   // [1/kg]
    float restitution;
    vec2 friction;       // static, kinetic
};

ParticleMass fetchMass(uint i)
{
    vec4 t = texelFetch(masses, int(i));
    return ParticleMass(t.x, t.y, t.zw);
}

/// Where a particle stands in the first of its bodies.
struct Arm {
    vec3 r;                   // in the body's axes, from its centre [m]
    float worstInverseMass;   // the largest that an impulse there can meet [1/kg]
};

Arm armOf(vec4 t)
{
    return Arm(t.xyz, t.w);
}

Arm fetchArm(uint i)
{
    return armOf(texelFetch(restOffsets, int(i)));
}
