// Where movers are (bodies, and loose particles as bodies that cannot turn), and how `moverMoves` holds their moves.
#include "math/quaternion.glsl"

uniform samplerBuffer moverCentres;      // at the start of the substep [m]
uniform samplerBuffer moverRotations;

vec3 fetchCentre(uint mover)
{
    return texelFetch(moverCentres, int(mover)).xyz;
}

vec4 fetchRotation(uint mover)
{
    return texelFetch(moverRotations, int(mover));
}

/// How far a mover has come since the start of the substep.
struct MoverMove {
    vec3 shift;     // of its centre [m]
    // Number of impulses over which contacts see its mass split, scaled (mass_scaling.glsl), over the relaxation. 0: it
    // does not respond, or nothing has been summed yet.
    float splits;
};

MoverMove unpackMove(vec4 t)
{
    return MoverMove(t.xyz, t.w);
}

vec4 packMove(MoverMove move)
{
    return vec4(move.shift, move.splits);
}
