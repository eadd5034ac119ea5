// One thread a body: notes where it is at the start of the substep, from where it has not moved yet.
#include "sim/common/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverCentres;
uniform samplerBuffer moverRotations;
BUFFER(vec4, BodyStarts, bodyStarts);    // centre, rotation
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);

void main()
{
    uint b = gl_GlobalInvocationID.x;
    if (b >= sim.bodyCount) return;
    bodyStarts[2u * b] = vec4(texelFetch(moverCentres, int(b)).xyz, 0);
    bodyStarts[2u * b + 1u] = texelFetch(moverRotations, int(b));
    moverMoves[b] = vec4(0);
    moverRotationDeltas[b] = vec4(0, 0, 0, 1);
}
