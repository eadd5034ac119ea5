// One thread a node of a rope: what its contacts with colliders add to the rope's equations, where the node is now.
// FIRST_ITERATION: of a substep, in which they have not pushed yet.
#include "sim/common/kernel.glsl"
#include "sim/strand/node_contacts.glsl"
#include "sim/strand/rope_contact.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverMoves;
uniform samplerBuffer colliderImpulses;
uniform samplerBuffer colliderMeans;
BUFFER(vec4, NodeContacts, nodeContacts);

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= uint(textureSize(ropeNodes))) return;
    uint node = texelFetch(ropeNodes, int(index)).x, mover = texelFetch(distanceNodes, int(node)).x;
    Mover own = fetchMover(mover);
    vec3 move = unpackMove(texelFetch(moverMoves, int(mover))).shift, push = vec3(0);
    mat3 stiffness = mat3(0);
    uint parity = counters[0].listParity;
    uvec2 range = listRange(parity, LIST_COLLIDERS, own.firstRank, responds(mover) ? 1u : 0u);
    for (uint q = range.x; q < range.y; ++q) {
        int entry = int(parity * sim.colliderPairCapacity + q);
        vec3 last = fetchImpulse(colliderImpulses, uint(entry)).whole;
        RopeTouch c = touchOf(mover, 1.0 / own.inverseMass, q, move, last, texelFetch(colliderMeans, entry).x);
        push += c.push;
        stiffness += c.stiffness;
#ifndef FIRST_ITERATION
        push -= last;
#endif
    }
    for (int column = 0; column < 3; ++column)
        nodeContacts[contactColumn(node, uint(column))] = vec4(stiffness[column], push[column]);
}
