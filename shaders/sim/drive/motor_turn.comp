// One thread a motor or a spring of a joint: the torque between its bodies from where they are now, and its stiffness
// in the joint's block.
#include "sim/common/kernel.glsl"
#include "shared/drive_types.h"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/drive/motor_pose.glsl"
#include "sim/drive/spring_time.glsl"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(Motor, Motors, motors);
uniform usamplerBuffer jointFreedoms;
uniform samplerBuffer motorStates;
BUFFER(vec4, DriveStiffness, driveStiffness);
BUFFER(vec4, RowAngularImpulses, newRowAngularImpulses);

/// @param torque on the body [kg m2]; its parent gets the opposite.
void storeTorque(Motor motor, vec3 torque, mat3 block)
{
    uint first = DRIVE_STIFFNESS_TEXELS * motor.joint;
    vec3 diagonal = diagonalOf(block);
    newRowAngularImpulses[motor.row].xyz = torque;
    if (motor.parentRow != NONE) newRowAngularImpulses[motor.parentRow].xyz = -torque;
    driveStiffness[first] = vec4(diagonal, isStale(driveStiffness[first].xyz, diagonal));
    driveStiffness[first + 1u].xyz = offDiagonalOf(block);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.motorCount) return;
    Motor motor = motors[k];
    if (!responds(motor.body) || texelFetch(jointFreedoms, int(motor.joint)).x == JOINT_NONE) {
        storeTorque(motor, vec3(0), mat3(0));
        return;
    }
    SpringTime time = springTime(motor.body);
    int state = int(MOTOR_STATE_TEXELS * k);
    vec4 began = texelFetch(motorStates, state + int(MOTOR_POSE));
    vec4 parent = turnedNow(motor.parent), body = turnedNow(motor.body);
    vec4 pose = motorPose(motor, parent, body, began);
    vec3 changed = texelFetch(motorStates, state + int(MOTOR_CHANGE)).xyz;
    vec3 rate = rateOf(poseChange(motor, began, pose), changed, time);
    vec3 away = motor.isHinge == 1u ? vec3(pose.x - motor.angle, 0, 0) : turnOfQuaternion(pose);
    float near = boundedPart(away, motor.reach), stiffness = near * motor.stiffness;
    vec3 torque = -stiffness * away - motor.damping * (rate - vec3(motor.speed, 0, 0));
    float part = boundedPart(torque, motor.greatestTorque);
    vec4 frame = quaternionProduct(parent, motor.parentFrame);
    vec3 axis = rotate(body, rotate(motor.frame, vec3(1, 0, 0)));
    vec3 given = motor.isHinge == 1u ? torque.x * axis : rotate(frame, torque);
    mat3 about = motor.isHinge == 1u ? outerProduct(axis, axis) : mat3(1);
    float factor = time.squaredTime * part;
    storeTorque(motor, factor * given, part * implicitPart(stiffness, motor.damping, time) * about);
}
