// One contact as an accumulated impulse, in units of mass times displacement [kg m].

/// What a contact is made of.
struct Contact {
    vec3 normal;         // towards this particle
    float gap;           // now, negative in penetration [m]
    float startGap;      // at the start of the substep [m]
    vec3 slide;          // relative displacement since then [m]
    float inverseMass;   // of both sides together [1/kg]
    vec2 friction;       // static, kinetic
};

/// The impulse (tangential in xyz, normal in w) after one Jacobi iteration. The normal part lets `correction` of an
/// old penetration be taken back per substep, so that it adds next to no velocity; friction is Coulomb's, bounded by
/// the accumulated normal impulse (Macklin et al. 2014, eq. 24).
vec4 solveContact(Contact c, vec4 impulse)
{
    float depth = max(-c.startGap, 0.0);
    float error = c.gap + depth - min(step.correction * depth, step.maxCorrection);
    float scale = c.inverseMass > 0.0 ? step.relaxation / c.inverseMass : 0.0;
    float normal = max(impulse.w - scale * error, 0.0);
    vec3 tangent = impulse.xyz - scale * c.slide;
    tangent -= c.normal * dot(c.normal, tangent);
    float size = length(tangent);
    if (size > c.friction.x * normal) tangent *= min(c.friction.y * normal / max(size, 1e-20), 1.0);
    return vec4(tangent, normal);
}
