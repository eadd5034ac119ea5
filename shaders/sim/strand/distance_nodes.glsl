// Strands: particles in a row at given distances, each solved as a whole by one thread. A rope is one strand, cloth
// is many that cross. A strand's particles are its nodes; link k leads from node k to the next. BODIES: some of the
// particles are parts of bodies, which turn.
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/particles.glsl"

uniform usamplerBuffer strands;
uniform usamplerBuffer distanceNodes;
uniform samplerBuffer distanceLinks;

struct Strand {
    uint first, last;   // nodes
    uint assembly;
};

Strand fetchStrand(uint strand)
{
    uvec4 t = texelFetch(strands, int(strand));
    return Strand(t.x, t.y, t.z);
}

/// What never changes about a node.
struct NodeInfo {
    uint mover, rank, particle;
    // [1/kg]; for a particle of a body, number of nodes over which its mass is split. 0: it does not respond.
    float inverseMass;
};

NodeInfo fetchNodeInfo(uint node)
{
    uvec4 t = texelFetch(distanceNodes, int(node));
    return NodeInfo(t.x, t.y, t.z, responds(t.x) ? uintBitsToFloat(t.w) : 0.0);
}

/// Whether no node of a strand responds.
bool rests(Strand strand)
{
    for (uint node = strand.first; node <= strand.last; ++node)
        if (fetchNodeInfo(node).inverseMass > 0.0) return false;
    return true;
}

/// What never changes about a link.
struct DistanceLink {
    float restLength;   // [m]
    float compliance;   // [m/N]
    float tearForce;    // a tension beyond this tears it [N]
    float tearLength;   // and so does a length beyond this [m]
};

DistanceLink fetchDistanceLink(uint k)
{
    vec4 t = texelFetch(distanceLinks, int(k));
    return DistanceLink(t.x, t.y, t.z, t.w);
}

struct DistanceNode {
    NodeInfo info;
    MoverPoint point;
};

DistanceNode fetchNode(uint node)
{
    NodeInfo info = fetchNodeInfo(node);
#ifdef BODIES
    return DistanceNode(info, moverPoint(info.mover, fetchArm(info.particle).r));
#else
    MoverPoint point = MoverPoint(texelFetch(moverCentres, int(info.mover)).xyz, vec3(0),
                                  texelFetch(moverMoves, int(info.mover)).xyz, 1.0);
    return DistanceNode(info, point);
#endif
}

/// The vector from one node to another, now [m].
vec3 between(DistanceNode a, DistanceNode b)
{
    return b.point.centre - a.point.centre + (b.point.arm - a.point.arm) + (b.point.move - a.point.move);
}
