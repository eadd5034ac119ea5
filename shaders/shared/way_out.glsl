// Which way a pair of particles parts, decided when it is found.
#include "shared/one_sided.glsl"
#include "shared/contact_mass.glsl"

uniform samplerBuffer particleSurfaces;  // way out of the body at rest, zero for none; w: distance to its surface

/// The way out by the particle that is nearer to its body's surface; by the one that is left sooner where they are about
/// as near.
Way wayOut(int i, int j, uvec2 movers, vec3 apart)
{
    vec4 first = texelFetch(particleSurfaces, i), second = texelFetch(particleSurfaces, j);
    vec3 outFirst = -rotate(texelFetch(foundRotations, int(movers.x)), first.xyz);
    vec3 outSecond = rotate(texelFetch(foundRotations, int(movers.y)), second.xyz);
    float near = abs(second.w) - abs(first.w);   // above 0 where the first is nearer
    bool alike = abs(near) < 0.25 * step.diameter;
    bool byFirst = alike ? dot(outFirst, apart) > dot(outSecond, apart) : near > 0.0;
    if (first.xyz == vec3(0) || second.xyz == vec3(0)) byFirst = second.xyz == vec3(0);
    return Way(byFirst ? outFirst : outSecond, abs(byFirst ? first.w : second.w) >= step.diameter);
}
