// Distance rows: rows of particles at given distances, each solved as a whole by one thread. A rope is one row, cloth
// is many that cross. A row's particles are its nodes; link k leads from node k to the next. BODIES: some of the
// particles are parts of bodies, which turn.
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/body_responses.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/particles.glsl"

uniform usamplerBuffer distanceRows;
uniform usamplerBuffer distanceNodes;
uniform samplerBuffer distanceLinks;

struct DistanceRow {
    uint first, last;   // nodes
    uint assembly;
};

DistanceRow fetchRow(uint row)
{
    uvec4 t = texelFetch(distanceRows, int(row));
    return DistanceRow(t.x, t.y, t.z);
}

/// What never changes about a node.
struct NodeInfo {
    uint mover, rank, particle;
    float inverseMass;   // [1/kg]; of a particle of a body: over how many nodes its mass is split. 0: it does not respond
};

NodeInfo fetchNodeInfo(uint node)
{
    uvec4 t = texelFetch(distanceNodes, int(node));
    return NodeInfo(t.x, t.y, t.z, responds(t.x) ? uintBitsToFloat(t.w) : 0.0);
}

/// Whether nothing of a row responds.
bool rests(DistanceRow row)
{
    for (uint node = row.first; node <= row.last; ++node)
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

/// From one to another, now [m].
vec3 between(DistanceNode a, DistanceNode b)
{
    return b.point.centre - a.point.centre + (b.point.arm - a.point.arm) + (b.point.move - a.point.move);
}

/// How an impulse of 1 along n moves the node [1/kg]: of a body, 1/M n + (I^-1 (r x n)) x r.
vec3 response(DistanceNode node, vec3 n)
{
#ifdef BODIES
    if (node.info.mover < sim.bodyCount) {
        Response response = fetchBodyResponse(node.info.mover);
        if (response.a[0][0] > 0.0) {
            vec3 arm = node.point.arm, turn = response.b * n + response.d * cross(arm, n);
            return node.info.inverseMass * (response.a * n + cross(arm, n) * response.b + cross(turn, arm));
        }
        InverseInertia body = fetchInverseInertia(node.info.mover);
        vec4 rotation = texelFetch(moverRotations, int(node.info.mover));
        vec3 angle = symmetricMatrix(body.diagonal, body.offDiagonal) *
                      rotate(conjugate(rotation), cross(node.point.arm, n));
        return node.info.inverseMass * (body.inverseMass * n + cross(rotate(rotation, angle), node.point.arm));
    }
#endif
    return node.info.inverseMass * n;
}

/// The matrix that gives the impulse for a move of the node [kg]; zero of one that nothing moves.
mat3 massOf(DistanceNode node)
{
    bool held = node.info.inverseMass == 0.0;
#ifdef BODIES
    if (node.info.mover < sim.bodyCount)
        return held ? mat3(0) : inverse(mat3(response(node, vec3(1, 0, 0)), response(node, vec3(0, 1, 0)),
                                             response(node, vec3(0, 0, 1))));
#endif
    return mat3(held ? 0.0 : 1.0 / node.info.inverseMass);
}
