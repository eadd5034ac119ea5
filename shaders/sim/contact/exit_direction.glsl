// Which way a pair of particles parts, decided when it is found.
#include "sim/common/one_sided.glsl"
#include "sim/contact/contact_mass.glsl"

uniform usamplerBuffer particleInfo;
uniform samplerBuffer particleSurfaces;  // way out of the body at rest, zero for none; w: distance to its surface

/// The way out by the particle that is nearer to its body's surface; between both where they are about as near.
Way wayOut(int i, int j, uvec2 movers, vec3 apart)
{
    vec4 first = texelFetch(particleSurfaces, i), second = texelFetch(particleSurfaces, j);
    bool hasFirst = first.xyz != vec3(0), hasSecond = second.xyz != vec3(0);
    float nearer = abs(second.w) - abs(first.w);   // above 0: the first
    bool alike = hasFirst && hasSecond && abs(nearer) < 0.25 * sim.diameter;
    bool byFirst = hasFirst && (!hasSecond || nearer > 0.0);
    vec3 outFirst = -rotate(texelFetch(searchRotations, int(movers.x)), first.xyz);
    vec3 outSecond = rotate(texelFetch(searchRotations, int(movers.y)), second.xyz);
    vec3 away = alike ? outFirst + outSecond : byFirst ? outFirst : outSecond;
    float size = length(away);
    // Two that look the same way know nothing of each other; limbs of one assembly press each other around joints.
    bool kin = texelFetch(particleInfo, i).z == texelFetch(particleInfo, j).z;
    away = !kin && size > 0.3 ? away / size : vec3(0);
    return Way(away, abs(byFirst ? first.w : second.w) >= sim.diameter, kin);
}
