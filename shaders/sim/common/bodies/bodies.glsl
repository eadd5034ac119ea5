// What never changes about bodies, by their index.
#include "math/symmetric.glsl"

uniform usamplerBuffer bodyInfo;
uniform samplerBuffer bodyMoments;       // three a body: columns of the sum of m r r^T; w of the first: radius
uniform samplerBuffer bodyInertias;      // two a body, inverse: xx, yy, zz, 1 / mass; xy, xz, yz

Body fetchBody(uint b)
{
    uvec4 t = texelFetch(bodyInfo, int(b));
    return Body(t.x, t.y, t.z, t.w);
}

/// The sum of m r r^T over the links of a body [kg m2].
mat3 fetchMoments(uint b)
{
    int first = int(3u * b);
    return mat3(texelFetch(bodyMoments, first).xyz, texelFetch(bodyMoments, first + 1).xyz,
                texelFetch(bodyMoments, first + 2).xyz);
}

/// From a body's centre to the centre of its farthest particle [m].
float bodyRadius(uint b)
{
    return texelFetch(bodyMoments, int(3u * b)).w;
}

/// The same for any mover: a loose particle is its own centre [m].
float moverRadius(uint m)
{
    return m < sim.bodyCount ? bodyRadius(m) : 0.0;
}

/// The inverse mass and the inverse of the inertia tensor, in the body's axes.
struct InverseInertia {
    float inverseMass;   // [1/kg]
    vec3 diagonal;       // xx, yy, zz [1/(kg m2)]
    vec3 offDiagonal;    // xy, xz, yz
};

InverseInertia fetchInverseInertia(uint b)
{
    vec4 t = texelFetch(bodyInertias, int(2u * b));
    return InverseInertia(t.w, t.xyz, texelFetch(bodyInertias, int(2u * b + 1u)).xyz);
}

/// Whether a body shares particles with others.
bool hasJoints(uint body)
{
    return fetchBody(body).jointCount > 0u;
}
