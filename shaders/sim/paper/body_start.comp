// One thread a body: notes its place at the start of the substep, before it moves.
#include "sim/common/kernel.glsl"
#include "sim/paper/body_starts.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverCentres;
uniform samplerBuffer moverRotations;
BUFFER(vec4, BodyStarts, newBodyStarts);
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);

void main()
{
    uint b = gl_GlobalInvocationID.x;
    if (b >= sim.bodyCount) return;
    BodyStart start = BodyStart(texelFetch(moverCentres, int(b)).xyz, texelFetch(moverRotations, int(b)));
    STORE_BODY_START(newBodyStarts, b, start);
    moverMoves[b] = vec4(0);
    moverRotationDeltas[b] = vec4(0, 0, 0, 1);
}
