// What stackBlocks holds of the loops of a body of a stack.
#include "sim/contact/stack/stack_blocks.glsl"

#define FOR_LOOPS(body, loop, partner) \
    for (uint loop = 0u, partner; \
         loop < BODY_LOOPS && (partner = stackNeighbours(body)[1u + loop]) != NONE; ++loop)

uint loopRecord(uint loop)
{
    return STACK_LOOPS + STACK_LOOP_TEXELS * loop;
}

void clearLoop(uint body, uint loop)
{
    uint record = loopRecord(loop);
    storeInertia(body, record, noInertia());
    storeForce(body, record + STACK_ON_PARTNER, Force(vec3(0), vec3(0)));
}

/// Adds what a contact of a loop gives to the loop's record.
void addToLoop(uint body, uint loop, Inertia stiff, Force onPartner)
{
    uint record = loopRecord(loop), force = record + STACK_ON_PARTNER;
    storeInertia(body, record, add(loadInertia(body, record), stiff));
    storeForce(body, force, add(loadForce(body, force), onPartner));
}
