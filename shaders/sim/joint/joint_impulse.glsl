// The impulses between the bodies that share a particle. FIRST_ITERATION: of a substep; joints have no memory.
#include "sim/common/movers.glsl"
#include "sim/common/links.glsl"
#include "sim/common/mass_scaling.glsl"

uniform samplerBuffer moverChanges;      // w of the first of four: relaxation of contacts
uniform samplerBuffer linkMasses;        // effective inverse mass of a link's body at the particle
BUFFER(vec4, LinkImpulses, linkImpulses);

/// Where the body `owner.y` would have the particle by its link `owner.x`, from `origin`.
vec3 goal(uvec2 owner, vec3 origin)
{
    MoverPoint point = moverPoint(owner.y, fetchLink(owner.x).r);
    return point.centre - origin + (point.arm + point.move);
}

float splitInverseMass(uvec2 owner)
{
    float relaxation = texelFetch(moverChanges, int(4u * owner.y)).w;
    float splits = texelFetch(moverMoves, int(owner.y)).w / contactScale(texelFetch(moverCentres, int(owner.y)).xyz);
    return texelFetch(linkMasses, int(owner.x)).x * splits * relaxation;
}

/// What impulses are over the distance between goals, for bodies of that inverse mass together.
float impulseScale(float inverseMass)
{
    return inverseMass > 0.0 ? sim.jointRelaxation / inverseMass : 0.0;
}

void setImpulse(uint link, vec3 impulse)
{
#ifdef FIRST_ITERATION
    linkImpulses[link] = vec4(impulse, 0);
#else
    linkImpulses[link].xyz += impulse;
#endif
}
