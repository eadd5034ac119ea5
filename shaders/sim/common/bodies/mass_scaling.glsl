// Mass scaling (Macklin et al. 2014, 5.2): contacts see masses m exp(-k h), so that the lower of two moves less and
// piles converge sooner. It breaks momentum: MASS_SCALING, of a world that asks for it.

/// The factor by which contacts scale the inverse mass of a mover at `centre`.
float contactScale(vec3 centre)
{
#ifdef MASS_SCALING
    vec3 down = sim.gravity.xyz / max(length(sim.gravity.xyz), 1e-20);
    return exp(clamp(-sim.massScaling * dot(centre, down), -30.0, 30.0));
#else
    return 1.0;
#endif
}
