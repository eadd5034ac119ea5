// Where movers are (bodies, and loose particles as bodies that cannot turn), and how `moverMoves` holds their moves.
#include "math/quaternion.glsl"

uniform samplerBuffer moverCentres;      // at the start of the substep [m]; w: radiusExcess()
uniform samplerBuffer moverRotations;

vec3 fetchCentre(uint mover)
{
    return texelFetch(moverCentres, int(mover)).xyz;
}

/// By how much the radius of a loose particle differs from others' [m]; 0 for a body.
float radiusExcess(uint mover)
{
    return texelFetch(moverCentres, int(mover)).w;
}

vec2 radiusExcess(uvec2 movers)
{
    return vec2(radiusExcess(movers.x), radiusExcess(movers.y));
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
