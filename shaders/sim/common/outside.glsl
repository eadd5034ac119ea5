// Accelerations of movers from outside: by gravity, and if the world has them by wind and force fields.

#ifdef FORCES
uniform samplerBuffer moverAccelerations;

/// Acceleration of a free mover in this substep [m/s2].
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
