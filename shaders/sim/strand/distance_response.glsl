// How nodes answer to impulses.
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/body_responses.glsl"
#include "sim/strand/distance_nodes.glsl"

/// What joints leave no way to move still gives, as a share of what the body alone would: the inverse exists.
const float HELD = 1e-3;

/// The move of the node by an impulse of 1 along n [1/kg]: for a body, 1/M n + (I^-1 (r x n)) x r.
vec3 response(DistanceNode node, vec3 n)
{
#ifdef BODIES
    if (node.info.mover < sim.bodyCount) {
        InverseInertia body = fetchInverseInertia(node.info.mover);
        if (hasJoints(node.info.mover)) {
            Response response = fetchBodyResponse(node.info.mover);
            vec3 arm = node.point.arm, turn = response.b * n + response.d * cross(arm, n);
            vec3 move = response.a * n + cross(arm, n) * response.b + cross(turn, arm);
            return node.info.inverseMass * (move + HELD * body.inverseMass * n);
        }
        vec4 rotation = texelFetch(moverRotations, int(node.info.mover));
        vec3 angle = symmetricMatrix(body.diagonal, body.offDiagonal) *
                      rotate(conjugate(rotation), cross(node.point.arm, n));
        return node.info.inverseMass * (body.inverseMass * n + cross(rotate(rotation, angle), node.point.arm));
    }
#endif
    return node.info.inverseMass * n;
}

/// The matrix that gives the impulse for a move of the node [kg]; zero if nothing moves it.
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
