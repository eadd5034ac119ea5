// One thread a motor or a spring of a joint, at the start of a substep: how the joint is turned, and the change of that
// in the substep before.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/drive/motor_pose.glsl"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(Motor, Motors, motors);
BUFFER(vec4, MotorStates, motorStates);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.motorCount) return;
    Motor motor = motors[k];
    uint state = MOTOR_STATE_TEXELS * k;
    vec4 last = motorStates[state + MOTOR_POSE];
    vec4 began = motorPose(motor, fetchRotation(motor.parent), fetchRotation(motor.body), last);
    motorStates[state + MOTOR_POSE] = began;
    motorStates[state + MOTOR_CHANGE].xyz = poseChange(motor, last, began);
}
