// How wet bodies are, for what fluid would give where none gets: between a body and a collider that it lies on.

uniform samplerBuffer particleWets;  // by rank, three each
uniform samplerBuffer bodySeals;

/// Sums over the fluid around a solid particle.
struct ParticleWet {
    vec3 slope;      // of what the particle covers [1/m]
    float slopes;    // their sizes [1/m]
    vec3 impulse;    // [kg m]
    float pressure;  // sizes times what pressure gives over the slope [kg m]
    vec3 seal;       // directions out of colliders that it lies on
    float mass;      // sizes times the mass of a fluid particle [kg/m]
};

ParticleWet fetchParticleWet(uint rank)
{
    vec4 s = texelFetch(particleWets, int(3u * rank)), t = texelFetch(particleWets, int(3u * rank + 1u));
    vec4 u = texelFetch(particleWets, int(3u * rank + 2u));
    return ParticleWet(s.xyz, s.w, t.xyz, t.w, u.xyz, u.w);
}

/// What a particle of a body gets, over its `seal` [kg m].
float fetchBodySeal(uint body)
{
    return texelFetch(bodySeals, int(body)).x;
}
