// What a substep takes back of an error that a joint has when it begins: a part, and no faster than at a walk.

Motion leftOf(Motion error)
{
    const float CORRECTION = 0.5, MOST_SPEED = 1.0, MOST_TURNING = 20.0;   // of it; [m/s], [rad/s]
    float moved = length(error.t), turned = length(error.r);
    return Motion(error.t * (1.0 - min(CORRECTION, MOST_SPEED * sim.substepTime / max(moved, 1e-20))),
                  error.r * (1.0 - min(CORRECTION, MOST_TURNING * sim.substepTime / max(turned, 1e-20))));
}
