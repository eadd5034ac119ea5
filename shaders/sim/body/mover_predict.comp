// One thread a mover: how far it would move in the substep if nothing touched it, where the contacts' last impulses
// lead from there, and whether its contact candidates are still good. BDF2 (second-order velocities) where
// nothing touched its assembly lately, else symplectic Euler.
#include "sim/common/kernel.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/fields.glsl"
#include "sim/common/mass_scaling.glsl"
#include "sim/common/sleep.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverCentres;
uniform samplerBuffer moverRotations;
uniform samplerBuffer moverVelocities;
uniform samplerBuffer oldMoverVelocities;
uniform samplerBuffer oldMoverMoves;
uniform samplerBuffer moverImpulses;
uniform samplerBuffer bodyMoments;       // three columns a body: sum of m r r^T; w of the first: radius
uniform samplerBuffer searchCentres;      // w: how far it may drift
uniform samplerBuffer searchRotations;
uniform usamplerBuffer moverInfo;
uniform usamplerBuffer lastAssemblyState;
BUFFER(vec4, MoverPredictions, moverPredictions);   // field: the centre's move, A
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);
BUFFER(uvec2, AssemblyState, assemblyState);   // last substep with a contact, order of this one
BUFFER(Counters, CountersBlock, counters);

Field predictedMove(uint m, bool second)
{
    float h = sim.substepTime;
    Field v = fetchField(moverVelocities, m);
    if (!second) return Field(h * (v.t + h * sim.gravity.xyz), h * v.f);
    Field move = fetchField(oldMoverMoves, m), last = fetchField(oldMoverVelocities, m);
    return Field(move.t / 3.0 + h * (8.0 * v.t - 2.0 * last.t + 4.0 * h * sim.gravity.xyz) / 9.0,
                 move.f / 3.0 + h * (8.0 * v.f - 2.0 * last.f) / 9.0);
}

/// How far its farthest particle has come since its candidates were found, at most.
float drift(uint m, vec4 found, vec3 centre, vec4 rotation, float radius)
{
    vec4 since = quaternionProduct(rotation, conjugate(texelFetch(searchRotations, int(m))));
    return length(centre - found.xyz) + 2.0 * length(since.xyz) * radius;
}

void main()
{
    uint m = MOVER_OF_THREAD;
    if (m >= MOVER_END) return;
    uvec4 info = texelFetch(moverInfo, int(m));
    uint now = counters[0].substep;
    bool second = sim.secondOrder == 1u && now > 0u && texelFetch(lastAssemblyState, int(info.z)).x + 1u != now;
    bool asleep = isAsleep(info.z);
    second = second && !asleep;
    assemblyState[info.z].y = second ? 2u : 1u;
    float inverseMass = uintBitsToFloat(info.w);
    if (inverseMass == 0.0) return;

    vec4 rotation = texelFetch(moverRotations, int(m)), turn = vec4(0, 0, 0, 1);
    Field move = predictedMove(m, second);
    Field impulse = fetchField(moverImpulses, m);
    vec3 start = texelFetch(moverCentres, int(m)).xyz;
    float scale = contactScale(start);
    float radius = 0.0;
    if (IS_BODY(m)) {
        vec4 column = texelFetch(bodyMoments, int(3u * m));
        radius = column.w;
        mat3 moments = mat3(column.xyz, texelFetch(bodyMoments, int(3u * m + 1u)).xyz,
                            texelFetch(bodyMoments, int(3u * m + 2u)).xyz);
        move.f = (matrixFromQuaternion(rotation) + move.f) * moments;
        turn = matchedRotationDelta(move.f + scale * impulse.f, rotation, turn);
    }
    STORE_FIELD(moverPredictions, m, move)
    if (asleep) {
        // What sleeps splits its mass over no impulse: contacts take it for immovable.
        moverMoves[m] = vec4(0);
        moverRotationDeltas[m] = vec4(0, 0, 0, 1);
        return;
    }
    vec3 shift = move.t + inverseMass * (scale * impulse.t);
    moverMoves[m].xyz = shift;
    moverRotationDeltas[m] = turn;
    vec3 centre = start + shift;
    vec4 found = texelFetch(searchCentres, int(m));
    if (info.y > 0u && drift(m, found, centre, quaternionProduct(turn, rotation), radius) > found.w)
        counters[0].due = 1u;
}
