// One thread a pin: the force and the torque on its body, from where it is now, and what they add to the block of the
// body's joint. As drive_joint, in the axes of the world. BEGIN: where a substep begins.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/drive/drive_spring.glsl"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(GpuPin, Pins, pins);
uniform samplerBuffer clipBodyPlaces;   // centre, rotation
#ifdef BEGIN
uniform samplerBuffer moverVelocities;
#endif
BUFFER(vec4, PinStates, pinStates);
BUFFER(vec4, DriveStiffness, driveStiffness);
BUFFER(vec4, RowImpulses, newRowImpulses);
BUFFER(vec4, RowAngularImpulses, newRowAngularImpulses);
BUFFER(vec4, PinsGiven, pinsGiven);

#define STATE_TURN 0u      // from the clip, when the substep began
#define STATE_TURNED 1u    // the clip at its end
#define STATE_CHANGE 2u    // of the turn in the substep before; w: the part of its torque that its greatest one left
#define STATE_WAY 3u       // the same of the place; from the clip, when the substep began
#define STATE_PLACE 4u
#define STATE_MOVED 5u

struct Pulled {
    vec3 force, torque;      // in units of mass times displacement
    float block;             // for moves [kg]
    mat3 turning;            // for turns [kg m2]
};

void storePull(GpuPin pin, Pulled p)
{
    uint first = DRIVE_STIFFNESS_TEXELS * pin.joint + 2u;
    vec3 diagonal = diagonalOf(p.turning);
#ifdef BEGIN
    float stale = 0.0;
#else
    float stale = max(isStale(driveStiffness[first].xyz, diagonal), isStale(vec3(driveStiffness[first].w, 0, 0),
                                                                            vec3(p.block, 0, 0)));
    newRowImpulses[pin.row].xyz = p.force;
    newRowAngularImpulses[pin.row].xyz = p.torque;
#endif
    driveStiffness[first] = vec4(diagonal, p.block);
    driveStiffness[first + 1u] = vec4(offDiagonalOf(p.turning), stale);
}

#ifdef BEGIN
/// What it gave in the substep that has ended is counted.
void count(uint p, uint body)
{
    uint given = PIN_GIVEN_TEXELS * p;
    vec3 force = pinsGiven[given].xyz;
    pinsGiven[given + 2u] += sim.substepTime * vec4(force, dot(force, fetchField(moverVelocities, body).t));
}

void begin(uint p, uint body, uint target)
{
    uint state = PIN_STATE_TEXELS * p;
    vec4 turn = quaternionProduct(fetchRotation(body), conjugate(pinStates[state + STATE_TURNED]));
    vec3 way = fetchCentre(body) - pinStates[state + STATE_PLACE].xyz;
    pinStates[state + STATE_CHANGE].xyz =
        turnOfQuaternion(quaternionProduct(turn, conjugate(pinStates[state + STATE_TURN])));
    vec3 moved = way - pinStates[state + STATE_WAY].xyz, place = texelFetch(clipBodyPlaces, int(2u * target)).xyz;
    count(p, body);
    pinStates[state + STATE_MOVED].xyz = moved;
    pinStates[state + STATE_TURN] = turn;
    pinStates[state + STATE_WAY].xyz = way;
    pinStates[state + STATE_PLACE].xyz = place;
    pinStates[state + STATE_TURNED] = texelFetch(clipBodyPlaces, int(2u * target + 1u));
}
#endif

/// Where the body is now.
Pulled pullOf(uint p, GpuPin pin, uint body, float level)
{
    uint state = PIN_STATE_TEXELS * p;
    Assembly assembly = fetchAssembly(fetchMover(body).assembly);
    bool second = assembly.order == 2u;
    float squaredTime = accelerationFactor(assembly) * sim.substepTime * sim.substepTime;
    float stiffness = level * pin.stiffness, damping = sqrt(level) * pin.damping, mass = pin.inertiaBeside.w;
    vec4 rotation = turnedNow(body), change = pinStates[state + STATE_CHANGE], moved = pinStates[state + STATE_MOVED];
    mat3 inertia = inertiaNow(pin.inertia, pin.inertiaBeside, rotation);
#ifndef BEGIN
    vec4 turn = quaternionProduct(rotation, conjugate(pinStates[state + STATE_TURNED]));
    vec3 turned = turnOfQuaternion(quaternionProduct(turn, conjugate(pinStates[state + STATE_TURN])));
    vec3 way = fetchCentre(body) + fetchMove(body).shift - pinStates[state + STATE_PLACE].xyz;
    vec3 turning = rateOf(turned, change.xyz, second) / sim.substepTime;
    vec3 moving = rateOf(way - pinStates[state + STATE_WAY].xyz, moved.xyz, second) / sim.substepTime;
    vec3 torque = -inertia * (stiffness * turnOfQuaternion(turn) + damping * turning);
    vec3 force = -mass * (stiffness * way + damping * moving);
    change.w = boundedPart(length(torque), level * pin.inertia.w);
    moved.w = boundedPart(length(force), level * pin.greatestForce);
    pinStates[state + STATE_CHANGE].w = change.w;
    pinStates[state + STATE_MOVED].w = moved.w;
    torque *= change.w;
    force *= moved.w;
    pinsGiven[PIN_GIVEN_TEXELS * p].xyz = force;
    pinsGiven[PIN_GIVEN_TEXELS * p + 1u].xyz = torque;
#else
    vec3 force = vec3(0), torque = vec3(0);
#endif
    float added = squaredTime * implicitPart(stiffness, damping, second);
    return Pulled(squaredTime * force, squaredTime * torque, moved.w * added * mass, change.w * added * inertia);
}

void main()
{
    uint p = gl_GlobalInvocationID.x;
    if (p >= sim.pinCount) return;
    GpuPin pin = pins[p];
    uint body = animatedBodies[pin.body].mover;
#ifdef BEGIN
    begin(p, body, pin.body);
#endif
    float level = texelFetch(driveLevels, int(pin.body)).x;
    if (level == 0.0 || !responds(body)) {
        storePull(pin, Pulled(vec3(0), vec3(0), 0.0, mat3(0)));
        pinsGiven[PIN_GIVEN_TEXELS * p].xyz = vec3(0);
        pinsGiven[PIN_GIVEN_TEXELS * p + 1u].xyz = vec3(0);
        return;
    }
    storePull(pin, pullOf(p, pin, body, level));
}
