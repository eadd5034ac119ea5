// One thread a contact between particles: takes its impulse back, if a collision's blow came through it within the
// substep. Its sides did not approach before, so that it would pass the blow on without restitution: instead it is a
// collision of the next substep.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/restitution/blows.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer pairSides;
uniform samplerBuffer moverRestitutionSplits;
FLOAT_TEXELS(pairImpulses)
BUFFER(vec4, PairRestitutions, pairRestitutions);
READ_BUFFER(Counters, CountersBlock, counters);

bool reached(uint mover)
{
    return texelFetch(moverRestitutionSplits, int(mover)).x != 0.0;
}

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    ContactSides sides = fetchContactSides(pairSides, q);
    uvec2 movers = sides.movers;
    if (!responds(movers.x) || !responds(movers.y) || sides.exit.sameAssembly) return;
    if (reached(movers.x) == reached(movers.y)) return;
    uint index = counters[0].listParity * sim.pairCapacity + q;
    Impulse solver = unpackImpulse(imageLoad(pairImpulses, int(index)));
    if (solver.normal <= 0.0 || unpackImpulse(pairRestitutions[index]).normal != 0.0) return;
    pairRestitutions[index] = packImpulse(Impulse(-solver.whole / sim.substepTime, TAKEN_BACK));
    imageStore(pairImpulses, int(index), packImpulse(Impulse(vec3(0), ABOUT_TO_ACT)));
}
