// How a motor's joint is turned.
#include "shared/motor_types.h"
#include "sim/drive/turns.glsl"

// Texels of motorStates.
#define MOTOR_POSE 0u      // when the substep began
#define MOTOR_CHANGE 1u    // of it in the substep before [rad]

/// Of a hinge x, its angle [rad], which goes on beyond a whole turn; else its turn, in the joint's axes of the parent.
/// @param last from which it came here.
vec4 motorPose(Motor motor, vec4 parent, vec4 body, vec4 last)
{
    vec4 turn = quaternionProduct(conjugate(quaternionProduct(parent, motor.parentFrame)),
                                  quaternionProduct(body, motor.frame));
    return motor.isHinge == 0u ? turn : vec4(angleAboutX(turn, last.x), 0, 0, 0);
}

vec3 poseChange(Motor motor, vec4 from, vec4 to)
{
    return motor.isHinge == 1u ? vec3(to.x - from.x, 0, 0) : turnBetween(from, to);
}
