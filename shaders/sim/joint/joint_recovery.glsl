// The part of a joint's initial error that a substep corrects, no faster than at a walk.
#include "math/spatial.glsl"

/// The part of an error that is kept. @param error its size. @param most the most that is corrected in a second.
float keptPart(float error, float most)
{
    const float CORRECTION = 0.5;
    return 1.0 - min(CORRECTION, most * sim.substepTime / max(error, 1e-20));
}

/// The part of a rigid stop's excess that is kept. A joint beyond a limit is not open, and may take its time; 20 rad/s
/// would fling back a load of 100 : 1.
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
