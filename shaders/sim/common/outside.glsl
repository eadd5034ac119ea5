// How movers are accelerated from outside: by gravity, and where the world has them by wind and force fields.

#ifdef FORCES
uniform samplerBuffer moverAccelerations;

/// Of what nothing holds, in this substep [m/s2].
vec3 outsideAcceleration(uint mover)
{
    return texelFetch(moverAccelerations, int(mover)).xyz;
}
#else
vec3 outsideAcceleration(uint mover)
{
    return sim.gravity.xyz;
}
#endif
