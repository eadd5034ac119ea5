// One thread a body: the rotation nearest to A (eqs. 11-17).
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/paper/body_acting.glsl"
#include "sim/paper/body_starts.glsl"
#include "sim/rotation/rotation_delta.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer bodyMatrices;
BUFFER(BodyActingSums, BodyActing, bodyActing);
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverCentres, moverCentres);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);      // since the substep began
BUFFER(vec4, MoverRotations, moverRotations);

void main()
{
    uint b = gl_GlobalInvocationID.x;
    if (b >= sim.bodyCount) return;
    bodyActing[b] = BodyActingSums(0u, bodyActing[b].now);
    if (!responds(b)) {
        moverMoves[b] = vec4(0);   // its sums hold nothing but rounding
        return;
    }
    BodyStart start = fetchBodyStart(b);
    moverCentres[b] = vec4(start.centre, 0) + moverMoves[b];
    mat3 a;
    for (int column = 0; column < 3; ++column) a[column] = texelFetch(bodyMatrices, int(3u * b) + column).xyz;
    vec4 delta = matchedRotationDelta(a, start.rotation, moverRotationDeltas[b]);
    moverRotationDeltas[b] = delta;
    moverRotations[b] = normalize(quaternionProduct(delta, start.rotation));
}
