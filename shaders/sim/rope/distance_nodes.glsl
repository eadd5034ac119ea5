// Particles of distanceRows. BODIES: some of them are parts of bodies, which turn.
#include "sim/common/movers.glsl"

uniform usamplerBuffer distanceNodes;      // mover, rank, particle, share as the bits of a float
uniform samplerBuffer distanceLinks;       // to the next: rest length [m], compliance [m/N]; force, length that tear it
#ifdef BODIES
uniform samplerBuffer restOffsets;
uniform samplerBuffer bodyInertias;      // two a body, inverse: xx, yy, zz, 1 / mass; xy, xz, yz
#endif

struct DistanceNode {
    uint mover, rank;
    float share;        // inverse mass, or (body) over how many distanceRows its mass is split; 0: fixed
    MoverPoint point;
};

DistanceNode fetchNode(uint node)
{
    uvec4 info = texelFetch(distanceNodes, int(node));
    float share = uintBitsToFloat(info.w);
#ifdef BODIES
    return DistanceNode(info.x, info.y, share, moverPoint(info.x, texelFetch(restOffsets, int(info.z)).xyz));
#else
    MoverPoint point = MoverPoint(texelFetch(moverCentres, int(info.x)).xyz, vec3(0),
                                  texelFetch(moverMoves, int(info.x)).xyz, 1.0);
    return DistanceNode(info.x, info.y, share, point);
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
    if (node.mover < sim.bodyCount) {
        vec4 diagonal = texelFetch(bodyInertias, int(2u * node.mover));
        vec3 other = texelFetch(bodyInertias, int(2u * node.mover + 1u)).xyz;
        mat3 inverse = mat3(diagonal.x, other.x, other.y, other.x, diagonal.y, other.z, other.y, other.z, diagonal.z);
        vec4 rotation = texelFetch(moverRotations, int(node.mover));
        vec3 turn = inverse * rotate(conjugate(rotation), cross(node.point.arm, n));
        return node.share * (diagonal.w * n + cross(rotate(rotation, turn), node.point.arm));
    }
#endif
    return node.share * n;
}

/// The matrix that gives the impulse for a move of the node [kg]; of one that is fixed nothing.
mat3 massOf(DistanceNode node)
{
#ifdef BODIES
    if (node.mover < sim.bodyCount)
        return node.share == 0.0 ? mat3(0) : inverse(mat3(response(node, vec3(1, 0, 0)), response(node, vec3(0, 1, 0)),
                                                          response(node, vec3(0, 0, 1))));
#endif
    return mat3(node.share == 0.0 ? 0.0 : 1.0 / node.share);
}
