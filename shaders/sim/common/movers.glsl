// Where movers are: bodies, and loose particles as bodies that cannot turn.
#include "math/quaternion.glsl"

uniform samplerBuffer moverCentres;      // at the start of the substep [m]
uniform samplerBuffer moverRotations;
uniform samplerBuffer moverMoves;        // since [m]; w: over how many impulses its mass is split
uniform samplerBuffer moverRotationDeltas;

struct MoverPoint {
    vec3 centre;    // at the start [m]
    vec3 arm;       // from there to the point, at the start [m]
    vec3 move;      // of the point since [m]
    float splits;   // over how many impulses the mover's mass is split
};

/// A point of a mover at r. The move comes from the turn, not from two positions, so that its rounding stays as small
/// as itself.
MoverPoint moverPoint(uint mover, vec3 r)
{
    vec3 arm = rotate(texelFetch(moverRotations, int(mover)), r);
    vec4 turn = texelFetch(moverRotationDeltas, int(mover));
    vec4 move = texelFetch(moverMoves, int(mover));
    vec3 t = 2.0 * cross(turn.xyz, arm);
    return MoverPoint(texelFetch(moverCentres, int(mover)).xyz, arm,
                      move.xyz + turn.w * t + cross(turn.xyz, t), move.w);
}
