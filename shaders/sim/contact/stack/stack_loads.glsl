// What stack_solve eliminates of a body: its own inertia and load, and what of them is felt through its contacts.
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "math/spatial_solve.glsl"

uniform samplerBuffer moverPredictions;
uniform samplerBuffer bodyPushes;
BUFFER(vec4, MoverMoves, newMoves);
BUFFER(vec4, MoverRotationDeltas, newDeltas);

vec3 centreNow(uint body)
{
    return fetchCentre(body) + newMoves[body].xyz;
}

/// Adds what is left of a body's prediction and of the impulses on it, and its inertia.
void addOwn(uint body, inout Inertia inertia, inout Force force)
{
    Field prediction = fetchField(moverPredictions, body), push = fetchField(bodyPushes, body);
    mat3 moments = fetchMoments(body);
    vec4 start = fetchRotation(body);
    mat3 before = matrixFromQuaternion(start), turned = turnOfAxes(start, newDeltas[body]);
    mat3 left = prediction.f - before * moments - turned * moments + push.f, r = before + turned;
    float mass = moverMass(body);
    force.t += mass * (prediction.t - newMoves[body].xyz) + push.t;
    force.r += cross(r[0], left[0]) + cross(r[1], left[1]) + cross(r[2], left[2]);
    mat3 spread = r * moments * transpose(r);
    inertia.a += mat3(mass);
    inertia.d += mat3(traceOf(spread)) - spread;
}

/// The part of an inertia that is felt through a spring: both in series, a - a (a + k)^-1 a.
Inertia inSeries(Inertia m, FactoredInertia withSpring)
{
    mat3 turnsA = solve(withSpring.turn, m.b), turnsD = solve(withSpring.turn, m.d);
    mat3 movesA = solve(withSpring.move, m.a - transpose(withSpring.b) * turnsA);
    mat3 movesD = solve(withSpring.move, transpose(m.b) - transpose(withSpring.b) * turnsD);
    turnsA = solve(withSpring.turn, m.b - withSpring.b * movesA);
    turnsD = solve(withSpring.turn, m.d - withSpring.b * movesD);
    return Inertia(m.a - m.a * movesA - transpose(m.b) * turnsA, m.b - m.b * movesA - m.d * turnsA,
                   m.d - m.b * movesD - m.d * turnsD);
}

Force less(Force x, Force y)
{
    return Force(x.t - y.t, x.r - y.r);
}
