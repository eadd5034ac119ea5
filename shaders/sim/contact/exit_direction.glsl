// In which direction the particles of a pair leave each other, decided when the pair is found.
#include "sim/contact/contact_mass.glsl"

uniform samplerBuffer particleSurfaces;

/// What a particle knows of the surface of its body.
struct ParticleSurface {
    vec3 exit;        // the exit direction in the body's axes, zero for none
    float distance;   // to the surface, below 0 inside [m]
};

ParticleSurface fetchSurface(uint i)
{
    vec4 t = texelFetch(particleSurfaces, int(i));
    return ParticleSurface(t.xyz, t.w);
}

/// By the particle that is nearer to its body's surface; the middle of both directions if they are about as near.
/// @param touch the distance at which the two touch [m].
ExitDirection exitDirection(Pair pair, uvec2 movers, float touch)
{
    ParticleSurface first = fetchSurface(pair.first), second = fetchSurface(pair.second);
    bool hasFirst = first.exit != vec3(0), hasSecond = second.exit != vec3(0);
    float nearer = abs(second.distance) - abs(first.distance);   // above 0: the first is
    bool alike = hasFirst && hasSecond && abs(nearer) < 0.25 * touch;
    bool byFirst = hasFirst && (!hasSecond || nearer > 0.0);
    // The second particle leaves the first one's body: the first goes the other way.
    vec3 exitFirst = -rotate(texelFetch(searchRotations, int(movers.x)), first.exit);
    vec3 exitSecond = rotate(texelFetch(searchRotations, int(movers.y)), second.exit);
    vec3 direction = alike ? exitFirst + exitSecond : byFirst ? exitFirst : exitSecond;
    float size = length(direction);
    // Two surfaces that face the same way give no direction. Limbs of one assembly press each other around joints.
    bool sameAssembly = fetchParticle(pair.first).assembly == fetchParticle(pair.second).assembly;
    direction = !sameAssembly && size > 0.3 ? direction / size : vec3(0);
    return ExitDirection(direction, abs(byFirst ? first.distance : second.distance) >= touch, sameAssembly);
}
