// Properties of materials as viscous fluids.

uniform samplerBuffer viscousMaterials;

struct ViscousMaterial {
    float thickness;   // of a pair of its particles, over a^3 r^2 (viscous_pairs.glsl) [kg/m2]
    float wallGrip;    // of a wall, over wallShear() [kg m]
    float solidGrip;   // of a solid particle, over solidShear() r^2 [kg/m2]
    float slip;        // slip length at walls [m]
};

/// Fluids that are not have no grip.
bool isViscous(ViscousMaterial material)
{
    return material.wallGrip > 0.0;
}

ViscousMaterial fetchViscousMaterial(uint material)
{
    vec4 t = texelFetch(viscousMaterials, int(material));
    return ViscousMaterial(t.x, t.y, t.z, t.w);
}
