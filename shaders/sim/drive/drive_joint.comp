// One thread a driven joint: the torque between its bodies from where they are now, and its stiffness in the joint's
// block.
#include "sim/common/kernel.glsl"
#include "sim/drive/drive_spring.glsl"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(JointDrive, JointDrives, jointDrives);
uniform usamplerBuffer jointFreedoms;
BUFFER(vec4, DriveStates, driveStates);
BUFFER(vec4, DriveStiffness, driveStiffness);
BUFFER(vec4, RowAngularImpulses, newRowAngularImpulses);

/// The inertia that a spring turns about its free axes; for a spring of given stiffness, 1 about these axes.
mat3 springInertia(JointDrive drive, vec4 rotation)
{
    mat3 inertia = drive.isGiven == 1u ? mat3(1) : fetchInertia(drive.body, 0u);
    vec3 axis = rotate(rotation, drive.axis.xyz);
    return drive.axis.w == 0.0 ? inertia : dot(axis, inertia * axis) * outerProduct(axis, axis);
}

/// @param torque on the body [kg m2]; its parent gets the opposite.
void storeTorque(JointDrive drive, vec3 torque, mat3 block)
{
    uint first = DRIVE_STIFFNESS_TEXELS * drive.joint;
    vec3 diagonal = diagonalOf(block);
    newRowAngularImpulses[drive.row].xyz = torque;
    newRowAngularImpulses[drive.parentRow].xyz = -torque;
    driveStiffness[first] = vec4(diagonal, isStale(driveStiffness[first].xyz, diagonal));
    driveStiffness[first + 1u].xyz = offDiagonalOf(block);
}

void main()
{
    uint j = gl_GlobalInvocationID.x;
    if (j >= sim.jointDriveCount) return;
    JointDrive drive = jointDrives[j];
    AnimatedBody at = animatedBodies[drive.body];
    float level = texelFetch(driveLevels, int(drive.body)).x;
    uint state = DRIVE_STATE_TEXELS * j;
    if (level == 0.0 || !responds(at.mover) || texelFetch(jointFreedoms, int(drive.joint)).x == JOINT_NONE) {
        driveStates[state + DRIVE_CHANGE].w = 1.0;
        storeTorque(drive, vec3(0), mat3(0));
        return;
    }
    SpringTime time = springTime(at.mover);
    float stiffness = level * drive.stiffness, damping = sqrt(level) * drive.damping;
    vec4 parent = turnedNow(animatedBodies[at.parent].mover), rotation = turnedNow(at.mover);
    vec4 from = turnFrom(driveStates[state + DRIVE_TARGET], parent, rotation);
    vec3 turned = turnBetween(driveStates[state + DRIVE_TURN], from);
    vec3 rate = rateOf(turned, driveStates[state + DRIVE_CHANGE].xyz, time);
    mat3 inertia = springInertia(drive, rotation);
    vec3 torque = -inertia * rotate(parent, stiffness * turnOfQuaternion(from) + damping * rate);
    float part = boundedPart(torque, level * drive.greatestTorque);
    driveStates[state + DRIVE_CHANGE].w = part;
    storeTorque(drive, time.squaredTime * part * torque, part * implicitPart(stiffness, damping, time) * inertia);
}
