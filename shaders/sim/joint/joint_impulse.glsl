// The impulses between the bodies that share a particle. FIRST_ITERATION: of a substep; joints have no memory.
#include "sim/common/bodies/body_rows.glsl"
#include "sim/common/bodies/links.glsl"
#include "sim/common/bodies/mass_splitting.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/bodies/owners.glsl"

uniform samplerBuffer linkMasses;        // the worst inverse mass of a link's body at the particle [1/kg]
uniform usamplerBuffer linkRows;         // of links of shared particles: their row of the channel
BUFFER(vec4, RowImpulses, rows);

/// Where a body would have the particle, from `origin`.
vec3 goal(Owner owned, vec3 origin)
{
    MoverPoint point = moverPoint(owned.body, fetchLink(owned.link).r);
    return point.centre - origin + (point.arm + point.move);
}

/// The inverse mass with which a body answers at the particle, split over its impulses.
float splitInverseMass(Owner owned)
{
    return splitOverImpulses(owned.body, texelFetch(linkMasses, int(owned.link)).x);
}

/// What impulses are over the distance between goals, for bodies of that inverse mass together.
float impulseScale(float inverseMass)
{
    return inverseMass > 0.0 ? sim.jointRelaxation / inverseMass : 0.0;
}

void setImpulse(uint link, vec3 impulse)
{
    uint row = texelFetch(linkRows, int(link)).x;
#ifdef FIRST_ITERATION
    rows[row] = packRow(impulse);
#else
    rows[row].xyz += impulse;
#endif
}
