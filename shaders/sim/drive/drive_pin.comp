// One thread a pin: the force and the torque on its body from where it is now, and its stiffness in the block of the
// body's joint.
#include "sim/common/kernel.glsl"
#include "sim/drive/drive_spring.glsl"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(Pin, Pins, pins);
BUFFER(vec4, PinStates, pinStates);
BUFFER(vec4, PinsGiven, pinsGiven);
BUFFER(vec4, DriveStiffness, driveStiffness);
BUFFER(vec4, RowImpulses, newRowImpulses);
BUFFER(vec4, RowAngularImpulses, newRowAngularImpulses);

struct Pull {
    vec3 force, torque;   // [N], [N m]
    float squaredTime;    // factor of forces [s2]
    float move;           // resistance that it adds to moves [kg] ...
    mat3 turn;            // ... and to turns [kg m2]
};

void storePull(uint p, Pin pin, Pull pull)
{
    uint first = DRIVE_STIFFNESS_TEXELS * pin.joint + 2u, given = PIN_GIVEN_TEXELS * p;
    vec4 before = driveStiffness[first];
    vec3 diagonal = diagonalOf(pull.turn);
    pinsGiven[given + GIVEN_FORCE].xyz = pull.force;
    pinsGiven[given + GIVEN_TORQUE].xyz = pull.torque;
    newRowImpulses[pin.row].xyz = pull.squaredTime * pull.force;
    newRowAngularImpulses[pin.row].xyz = pull.squaredTime * pull.torque;
    float stale = max(isStale(before.xyz, diagonal), isStale(vec3(before.w), vec3(pull.move)));
    driveStiffness[first] = vec4(diagonal, pull.move);
    driveStiffness[first + 1u] = vec4(offDiagonalOf(pull.turn), stale);
}

void main()
{
    uint p = gl_GlobalInvocationID.x;
    if (p >= sim.pinCount) return;
    Pin pin = pins[p];
    uint body = animatedBodies[pin.body].mover, state = PIN_STATE_TEXELS * p;
    float level = texelFetch(driveLevels, int(pin.body)).x;
    if (level == 0.0 || !responds(body)) {
        storePull(p, pin, Pull(vec3(0), vec3(0), 0.0, 0.0, mat3(0)));
        return;
    }
    SpringTime time = springTime(body);
    float stiffness = level * pin.stiffness, damping = sqrt(level) * pin.damping;
    float mass = texelFetch(driveInertias, int(4u * pin.body + 2u)).w;
    mat3 inertia = fetchInertia(pin.body, 1u);
    vec4 turn = quaternionProduct(turnedNow(body), conjugate(pinStates[state + PIN_TARGET_TURN]));
    vec3 turning = rateOf(turnBetween(pinStates[state + PIN_TURN], turn), pinStates[state + PIN_TURNED].xyz, time);
    vec3 way = fetchCentre(body) + fetchMove(body).shift - pinStates[state + PIN_TARGET_PLACE].xyz;
    vec3 moving = rateOf(way - pinStates[state + PIN_WAY].xyz, pinStates[state + PIN_MOVED].xyz, time);
    vec3 torque = -inertia * (stiffness * turnOfQuaternion(turn) + damping * turning);
    vec3 force = -mass * (stiffness * way + damping * moving);
    float turned = boundedPart(torque, level * pin.greatestTorque);
    float moved = boundedPart(force, level * pin.greatestForce);
    float added = implicitPart(stiffness, damping, time);
    storePull(p, pin, Pull(moved * force, turned * torque, time.squaredTime, moved * added * mass,
                           turned * added * inertia));
}
