// One thread a pin, at the start of a substep: its body's distance from its clip, the change of that in the substep
// before, and the pin's force and torque in that.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/drive/drive_states.glsl"
#include "sim/drive/turns.glsl"
#include "shared/animation_types.h"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(Pin, Pins, pins);
READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
uniform samplerBuffer clipBodyPlaces;   // centre, rotation
uniform samplerBuffer moverVelocities;
BUFFER(vec4, PinStates, pinStates);
BUFFER(vec4, PinsGiven, pinsGiven);

void main()
{
    uint p = gl_GlobalInvocationID.x;
    if (p >= sim.pinCount) return;
    Pin pin = pins[p];
    uint body = animatedBodies[pin.body].mover, state = PIN_STATE_TEXELS * p, given = PIN_GIVEN_TEXELS * p;
    vec4 turn = quaternionProduct(fetchRotation(body), conjugate(pinStates[state + PIN_TARGET_TURN]));
    pinStates[state + PIN_TURNED].xyz = turnBetween(pinStates[state + PIN_TURN], turn);
    pinStates[state + PIN_TURN] = turn;
    vec3 way = fetchCentre(body) - pinStates[state + PIN_TARGET_PLACE].xyz;
    pinStates[state + PIN_MOVED].xyz = way - pinStates[state + PIN_WAY].xyz;
    pinStates[state + PIN_WAY].xyz = way;
    pinStates[state + PIN_TARGET_PLACE] = texelFetch(clipBodyPlaces, int(2u * pin.body));
    pinStates[state + PIN_TARGET_TURN] = texelFetch(clipBodyPlaces, int(2u * pin.body + 1u));
    vec3 force = pinsGiven[given + GIVEN_FORCE].xyz;
    pinsGiven[given + GIVEN_SUM] += sim.substepTime * vec4(force, dot(force, fetchField(moverVelocities, body).t));
}
