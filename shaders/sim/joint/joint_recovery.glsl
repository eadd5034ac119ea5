// What a substep takes back of an error that a joint has when it begins: a part, and no faster than at a walk.
#include "math/spatial.glsl"

/// The part of an error that is kept. @param error its size. @param most how much may be taken back in a second.
float keptPart(float error, float most)
{
    const float CORRECTION = 0.5;
    return 1.0 - min(CORRECTION, most * sim.substepTime / max(error, 1e-20));
}

/// Of the excess of a rigid stop. What is beyond a limit is not apart, and may take its time; at 20 rad/s a load of
/// 100 : 1 would be flung back.
float keptOfExcess(float excess)
{
    const float MOST_TURNING = 1.0;   // [rad/s]
    return excess * keptPart(excess, MOST_TURNING);
}

Motion keptOf(Motion error)
{
    const float MOST_SPEED = 1.0;      // [m/s]
    const float MOST_TURNING = 20.0;   // [rad/s]
    return Motion(error.t * keptPart(length(error.t), MOST_SPEED),
                  error.r * keptPart(length(error.r), MOST_TURNING));
}
