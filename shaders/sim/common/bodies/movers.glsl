// Where points of movers are within a substep.
#include "sim/common/bodies/mover_poses.glsl"

uniform samplerBuffer moverMoves;
uniform samplerBuffer moverRotationDeltas;

MoverMove fetchMove(uint mover)
{
    return unpackMove(texelFetch(moverMoves, int(mover)));
}

/// By how much a mover has turned since the start of the substep.
vec4 fetchRotationDelta(uint mover)
{
    return texelFetch(moverRotationDeltas, int(mover));
}

struct MoverPoint {
    vec3 centre;    // of the mover, at the start [m]
    vec3 arm;       // from there to the point, at the start [m]
    vec3 move;      // of the point since [m]
    float splits;   // as of its MoverMove
};

/// The point of a mover at r in its axes.
MoverPoint moverPoint(uint mover, vec3 r)
{
    vec3 arm = rotate(fetchRotation(mover), r);
    MoverMove move = fetchMove(mover);
    return MoverPoint(fetchCentre(mover), arm, movedByTurn(move.shift, fetchRotationDelta(mover), arm), move.splits);
}
