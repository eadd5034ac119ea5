// One thread a node of a rope: the impulses of its contacts with colliders, once the rope has moved.
// FIRST_ITERATION: of a substep, in which they have not pushed yet; how far the node slides is not settled then.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/strand/node_contacts.glsl"
#include "sim/strand/rope_contact.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer nodeContacts;
BUFFER(vec4, ColliderImpulses, colliderImpulses);
BUFFER(float, ColliderMeans, colliderMeans);   // of these contacts: how far they slide in a substep
BUFFER(vec4, ParticleImpulses, particleImpulses);
BUFFER(Assembly, AssemblyState, assemblies);

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= uint(textureSize(ropeNodes))) return;
    uint node = texelFetch(ropeNodes, int(index)).x, mover = texelFetch(distanceNodes, int(node)).x;
    if (!responds(mover)) return;
    Mover own = fetchMover(mover);
    vec3 moved = texelFetch(nodeContacts, int(moveOf(node))).xyz, change = vec3(0);
    vec3 move = texelFetch(nodeContacts, int(moveBefore(node))).xyz;
    uint parity = counters[0].listParity;
    uvec2 range = listRange(parity, LIST_COLLIDERS, own.firstRank, 1u);
    for (uint q = range.x; q < range.y; ++q) {
        uint entry = parity * sim.colliderPairCapacity + q;
        vec3 last = unpackImpulse(colliderImpulses[entry]).whole;
        RopeTouch c = touchOf(mover, 1.0 / own.inverseMass, q, move, last, colliderMeans[entry]);
        vec3 whole = c.push - c.stiffness * moved;
        colliderImpulses[entry] = packImpulse(Impulse(whole, max(dot(whole, c.normal), 0.0)));
        change += whole;
#ifndef FIRST_ITERATION
        change -= last;
        colliderMeans[entry] = length(c.slide + moved - c.normal * dot(c.normal, moved));
#endif
    }
    if (change == vec3(0)) return;
    particleImpulses[own.firstRank].xyz += change;
    assemblies[own.assembly].lastContact = counters[0].substep - 1u;
}
