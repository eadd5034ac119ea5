// ParticleRigidBodyLink through a buffer texture: two texels of RGBA32UI a link.

uniform usamplerBuffer links;

struct LinkValues {
    uint particle;
    uint body;
    vec3 r;              // posInRigidBody [m]
    uint blockStart;
    float mass;          // [kg]
};

LinkValues fetchLink(uint l)
{
    uvec4 a = texelFetch(links, int(2u * l)), b = texelFetch(links, int(2u * l + 1u));
    vec3 r = vec3(uintBitsToFloat(a.z), uintBitsToFloat(a.w), uintBitsToFloat(b.x));
    return LinkValues(a.x, a.y, r, b.y, uintBitsToFloat(b.w));
}
