// A strand's nodes as strand_solve sees and moves them. CONTACTS: of a world with ropes whose contacts with colliders
// are solved with them (rope_contact.glsl).
#include "sim/strand/distance_response.glsl"
#include "sim/strand/precision.glsl"

BUFFER(vec4, MoverMoves, newMoverMoves);
BUFFER(vec4, ParticleImpulses, particleImpulses);
#ifdef CONTACTS
#include "sim/strand/node_contacts.glsl"
uniform usamplerBuffer ropeMovers;
BUFFER(vec4, NodeContacts, nodeContacts);

/// Whether the contacts of a node are solved with it.
bool hasContacts(uint node, uint mover)
{
    return texelFetch(ropeMovers, int(mover)).x == node + 1u;
}
#endif

/// A node's mass matrix and what acts on it: those of its contacts.
void ownOf(DistanceNode node, uint k, out REAL3X3 mass, out REAL3 r)
{
    mass = REAL3X3(massOf(node));
    r = REAL3(0);
#ifdef CONTACTS
    if (!hasContacts(k, node.info.mover)) return;
    for (int column = 0; column < 3; ++column) {
        vec4 t = nodeContacts[contactColumn(k, uint(column))];
        mass[column] += REAL3(t.xyz);
        r[column] = REAL(t.w);
    }
#endif
}

/// @param impulse of its links on a node. @param move of a node whose contacts answer, too.
void moveNode(uint node, vec3 impulse, vec3 move)
{
    NodeInfo info = fetchNodeInfo(node);
    if (info.inverseMass == 0.0) return;
    particleImpulses[info.rank].xyz += impulse;
    if (info.mover < sim.bodyCount) return;
#ifdef CONTACTS
    if (hasContacts(node, info.mover)) {
        nodeContacts[moveBefore(node)] = vec4(newMoverMoves[info.mover].xyz, 0);
        nodeContacts[moveOf(node)] = vec4(move, 0);
        newMoverMoves[info.mover].xyz += move;
        return;
    }
#endif
    newMoverMoves[info.mover].xyz += info.inverseMass * impulse;
}
