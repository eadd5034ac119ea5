// One contact as an accumulated impulse, in units of mass times displacement [kg m].

/// What a contact is made of.
struct Contact {
    vec3 normal;         // towards the first side
    float gap;           // now, negative in penetration [m]
    float startGap;      // at the start of the substep [m]
    vec3 slide;          // relative displacement since then [m]
    float inverseMass;   // of both sides together along the normal, each split over its impulses [1/kg]
    float worstMass;     // the same for the worst direction [1/kg]
    vec2 friction;       // static, kinetic
};

/// One Jacobi iteration of an impulse: the whole in xyz, its normal part in w, or ABOUT_TO_ACT where it has none yet
/// but will in the next iteration. Only contacts that were counted beforehand act: over those the mass is split. The
/// normal part lets `correction` of an old penetration be taken back per substep, so that it adds next to no velocity;
/// friction is Coulomb's, bounded by the accumulated normal impulse (Macklin et al. 2014, eq. 24).
vec4 solveContact(Contact c, vec4 impulse)
{
#ifdef SLEEP
    if (c.worstMass == 0.0 && impulse.w > 0.0) return impulse;   // both sides sleep
#endif
    float depth = max(-c.startGap, 0.0);
    float error = c.gap + depth - min(step.correction * depth, step.maxCorrection);
    bool acts = impulse.w != 0.0 && c.worstMass > 0.0;
    float push = acts ? error / c.inverseMass : 0.0;
    float normal = max(step.warmStart * max(impulse.w, 0.0) - push, 0.0);
    vec3 tangent = impulse.xyz - (acts ? 1.0 / c.worstMass : 0.0) * c.slide;
    tangent -= c.normal * dot(c.normal, tangent);
    float size = length(tangent);
    if (size > c.friction.x * normal) tangent *= min(c.friction.y * normal / max(size, 1e-20), 1.0);
    bool soon = 2.0 * c.gap < c.startGap;   // it will overlap after another move like this one
    return vec4(tangent + normal * c.normal, normal > 0.0 ? normal : soon ? ABOUT_TO_ACT : 0.0);
}
