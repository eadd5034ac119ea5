// Mass splitting (Tonge et al. 2012): a body answers to each of its impulses with a part of its mass.
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mass_scaling.glsl"
#include "sim/common/bodies/movers.glsl"

uniform samplerBuffer moverChanges;      // with the relaxation of contacts

/// An inverse mass of a mover, split over its impulses; 0 where it does not respond. The splits of moverMoves are those
/// of contacts: over their relaxation, and scaled for them.
float splitOverImpulses(uint mover, float inverseMass)
{
    float relaxation = fetchRelaxation(moverChanges, mover);
    float splits = fetchMove(mover).splits / contactScale(fetchCentre(mover));
    return inverseMass * splits * relaxation;
}
