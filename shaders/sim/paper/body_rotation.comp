// One thread a body: the rotation nearest to A (eqs. 11-17).
#include "sim/common/kernel.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/sleep.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer bodyMatrices;
uniform samplerBuffer bodyStarts;
uniform usamplerBuffer moverInfo;
BUFFER(uvec2, BodyActing, bodyActing);   // counted in this iteration, in the last (contact_average)
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverCentres, moverCentres);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);      // since the substep began
BUFFER(vec4, MoverRotations, moverRotations);

void main()
{
    uint b = gl_GlobalInvocationID.x;
    if (b >= sim.bodyCount) return;
    bodyActing[b] = uvec2(0u, bodyActing[b].x);
    if (isAsleep(texelFetch(moverInfo, int(b)).z)) {
        moverMoves[b] = vec4(0);   // what the sums make of nothing but rounding
        return;
    }
    moverCentres[b] = texelFetch(bodyStarts, int(2u * b)) + moverMoves[b];
    mat3 a;
    for (int column = 0; column < 3; ++column) a[column] = texelFetch(bodyMatrices, int(3u * b) + column).xyz;
    vec4 start = texelFetch(bodyStarts, int(2u * b + 1u));
    vec4 turned = matchedRotationDelta(a, start, moverRotationDeltas[b]);
    moverRotationDeltas[b] = turned;
    moverRotations[b] = normalize(quaternionProduct(turned, start));
}
