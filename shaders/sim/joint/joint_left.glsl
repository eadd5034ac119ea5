// What a substep takes back of an error that a joint has when it begins: a part, and no faster than at a walk.
#include "math/spatial.glsl"

/// The part of an error that is left. @param error its size. @param most how much may be taken back in a second.
float partLeft(float error, float most)
{
    const float CORRECTION = 0.5;
    return 1.0 - min(CORRECTION, most * sim.substepTime / max(error, 1e-20));
}

const float MOST_JOINT_TURNING = 20.0;   // [rad/s]

float leftOfTurn(float turned)
{
    return turned * partLeft(turned, MOST_JOINT_TURNING);
}

Motion leftOf(Motion error)
{
    const float MOST_SPEED = 1.0;   // [m/s]
    return Motion(error.t * partLeft(length(error.t), MOST_SPEED),
                  error.r * partLeft(length(error.r), MOST_JOINT_TURNING));
}
